// Reactions: forces that answer the forces found so far, and so come last in the list of a world.
// In 2D every z is zero and the same lines serve.
import { columns, get, put } from '../columns';

// The pull of an inextensible string from a pivot, when taut: what stops the stretching, T = F n + m v_t^2 / r.
// Inside `slack` times its length the string is slack, and it never pushes.
export function stringTension(
  fx: usize,
  fy: usize,
  fz: usize,
  cx: f64,
  cy: f64,
  cz: f64,
  length: f64,
  slack: f64,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let row = first; row < last; row++) {
    const mass = <f64>get(c.mass, row);
    if (!(mass > 0)) continue;
    let x = <f64>get(c.positionX, row) - cx;
    let y = <f64>get(c.positionY, row) - cy;
    let z = <f64>get(c.positionZ, row) - cz;
    const r = sqrt<f64>(x * x + y * y + z * z);
    if (!(r > 0) || r < slack * length) continue;
    x /= r;
    y /= r;
    z /= r;
    const vx = <f64>get(c.velocityX, row);
    const vy = <f64>get(c.velocityY, row);
    const vz = <f64>get(c.velocityZ, row);
    const out = vx * x + vy * y + vz * z;
    const across = vx * vx + vy * vy + vz * vz - out * out;
    const pull = <f64>get(fx, row) * x + <f64>get(fy, row) * y + <f64>get(fz, row) * z + (mass * across) / r;
    if (!(pull > 0)) continue;
    put(fx, row, get(fx, row) - <real>(pull * x));
    put(fy, row, get(fy, row) - <real>(pull * y));
    put(fz, row, get(fz, row) - <real>(pull * z));
  }
}

// Towards the centre, m v^2 / r and at most `grip` m: tyres on a bend.
export function bendForce(
  fx: usize,
  fy: usize,
  fz: usize,
  cx: f64,
  cy: f64,
  cz: f64,
  grip: f64,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let row = first; row < last; row++) {
    const mass = <f64>get(c.mass, row);
    if (!(mass > 0)) continue;
    const x = <f64>get(c.positionX, row) - cx;
    const y = <f64>get(c.positionY, row) - cy;
    const z = <f64>get(c.positionZ, row) - cz;
    const r = sqrt<f64>(x * x + y * y + z * z);
    if (!(r > 0)) continue;
    const vx = <f64>get(c.velocityX, row);
    const vy = <f64>get(c.velocityY, row);
    const vz = <f64>get(c.velocityZ, row);
    const size = (mass * min<f64>((vx * vx + vy * vy + vz * vz) / r, grip)) / r;
    put(fx, row, get(fx, row) - <real>(size * x));
    put(fy, row, get(fy, row) - <real>(size * y));
    put(fz, row, get(fz, row) - <real>(size * z));
  }
}

// A plane through (px, py, pz) with unit normal n that bodies stand, slide and roll on.
@unmanaged
export class Support {
  px: f64;
  py: f64;
  pz: f64;
  nx: f64;
  ny: f64;
  nz: f64;
  staticFriction: f64;
  kineticFriction: f64;
  // Within this distance of the plane a body touches it, m; below this slip it sticks, m/s.
  gap: f64;
  stick: f64;
}

// The normal force cancels what presses into the plane. Friction opposes the slip u = v_t - r omega x n of the point of
// contact: what holds is (D + m u/dt) / (1 + m r^2/I), which answers the driving force D and ends the slip within the
// step; sticking, it may be mu_s N, slipping, mu_k N against the slip. A body that cannot turn (no inertia, or without
// `bit`, that of AngularVelocity) has 1/I = 0: a block. Slip and spin are those at the start of the step (v0), in every
// evaluation: the angular velocity moves only when the step is over, and the two must belong together.
export function supportForce(
  support: usize,
  inertia: usize,
  bit: u32,
  fx: usize,
  fy: usize,
  fz: usize,
  tx: usize,
  ty: usize,
  tz: usize,
  v0x: usize,
  v0y: usize,
  v0z: usize,
  dt: f64,
  first: i32,
  last: i32,
): void {
  const s = changetype<Support>(support);
  const c = columns();
  for (let row = first; row < last; row++) {
    const mass = <f64>get(c.mass, row);
    if (!(mass > 0)) continue;
    const radius = <f64>get(c.radius, row);
    const height =
      (<f64>get(c.positionX, row) - s.px) * s.nx +
      (<f64>get(c.positionY, row) - s.py) * s.ny +
      (<f64>get(c.positionZ, row) - s.pz) * s.nz -
      radius;
    if (height > s.gap) continue;
    const x = <f64>get(fx, row);
    const y = <f64>get(fy, row);
    const z = <f64>get(fz, row);
    const normal = -(x * s.nx + y * s.ny + z * s.nz);
    if (!(normal > 0)) continue;
    const turns = (load<u32>(c.members + ((<usize>row) << 2)) & bit) != 0;
    const turning = turns ? <f64>get(inertia, row) : 0;
    const arm = turning > 0 ? radius : 0;
    const lever = turning > 0 ? (mass * radius * radius) / turning : 0;
    const ox = arm * <f64>get(c.angularVelocityX, row);
    const oy = arm * <f64>get(c.angularVelocityY, row);
    const oz = arm * <f64>get(c.angularVelocityZ, row);
    let ux = <f64>get(v0x, row) - (oy * s.nz - oz * s.ny);
    let uy = <f64>get(v0y, row) - (oz * s.nx - ox * s.nz);
    let uz = <f64>get(v0z, row) - (ox * s.ny - oy * s.nx);
    const into = ux * s.nx + uy * s.ny + uz * s.nz;
    ux -= into * s.nx;
    uy -= into * s.ny;
    uz -= into * s.nz;
    const slip = sqrt<f64>(ux * ux + uy * uy + uz * uz);
    const slipping = slip > s.stick;
    const hurry = mass / dt;
    let rx = -(x + normal * s.nx + hurry * ux) / (1 + lever);
    let ry = -(y + normal * s.ny + hurry * uy) / (1 + lever);
    let rz = -(z + normal * s.nz + hurry * uz) / (1 + lever);
    const needed = sqrt<f64>(rx * rx + ry * ry + rz * rz);
    const holds = needed <= s.staticFriction * normal * 1.000000000001;
    if (slipping && needed > s.kineticFriction * normal) {
      const scale = (-s.kineticFriction * normal) / slip;
      rx = scale * ux;
      ry = scale * uy;
      rz = scale * uz;
    } else if (!slipping && !holds) {
      const scale = (s.kineticFriction * normal) / needed;
      rx *= scale;
      ry *= scale;
      rz *= scale;
    }
    put(fx, row, <real>(x + normal * s.nx + rx));
    put(fy, row, <real>(y + normal * s.ny + ry));
    put(fz, row, <real>(z + normal * s.nz + rz));
    if (arm == 0) continue;
    put(tx, row, get(tx, row) - <real>(arm * (s.ny * rz - s.nz * ry)));
    put(ty, row, get(ty, row) - <real>(arm * (s.nz * rx - s.nx * rz)));
    put(tz, row, get(tz, row) - <real>(arm * (s.nx * ry - s.ny * rx)));
  }
}
