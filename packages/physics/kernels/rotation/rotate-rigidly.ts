// Rotation of bodies with an inertia tensor, Euler's equations of a rigid body.
//
//   dL/dt = torque, L = R I R^T omega        in the body's axes:  I domega/dt = torque - omega x (I omega)
//
// Free rotation by the implicit midpoint rule in the body's axes and a Cayley map of the orientation, which together
// keep the angular momentum in the world and the energy exactly, have order 2, and are reversed by -dt. Sources: Simo and
// Wong, Unconditionally stable algorithms for rigid body dynamics that exactly preserve energy and momentum, Int. J.
// Numer. Meth. Engng 31 (1991), 19-52; Austin, Krishnaprasad and Wang, Almost Poisson integration of rigid body systems,
// J. Comput. Phys. 107 (1993), 105-117.
import { hasTensor } from '../dynamics/has-tensor';
import { addTorque, get, ix, iy, iz, loadBody, rotateBy, storeBody, wx, wy, wz } from './tensor-body';

// Angle that a sub-step may rotate, rad: it errs by the twelfth part of its square, 1e-3 of the angle.
const MAX_ANGLE: f64 = 0.1;
const MAX_SUBSTEPS: f64 = 64;
const MAX_ITERATIONS: i32 = 12;
// Change of the last iteration, squared and relative: the next change would be its square.
const TOLERANCE: f64 = 1e-20;

// Applies torques for `kick` seconds to bodies with an inertia tensor, then rotates them freely for `dt`.
export function rotateRigidly(
  torqueX: usize,
  torqueY: usize,
  torqueZ: usize,
  kick: f64,
  dt: f64,
  first: i32,
  last: i32,
): void {
  for (let row = first; row < last; row++) {
    if (!hasTensor(row)) continue;
    if (loadBody(row) && kick != 0) {
      addTorque(kick * get(torqueX, row), kick * get(torqueY, row), kick * get(torqueZ, row));
    }
    if (wx == 0 && wy == 0 && wz == 0) continue;
    rotateFreely(dt);
    storeBody(row);
  }
}

// Adds an impulse of torque, N m s, to one body.
export function kickTensor(row: i32, x: f64, y: f64, z: f64): void {
  if (!loadBody(row)) return;
  addTorque(x, y, z);
  storeBody(row);
}

// |L| is constant, so a free body has as many sub-steps in every step, forwards and backwards.
function rotateFreely(dt: f64): void {
  const lx = ix * wx;
  const ly = iy * wy;
  const lz = iz * wz;
  const fastest = sqrt<f64>(lx * lx + ly * ly + lz * lz) / min<f64>(ix, min<f64>(iy, iz));
  const wanted = ceil<f64>((abs<f64>(dt) * fastest) / MAX_ANGLE);
  // A comparison with NaN is false: such a body takes one sub-step, and the checks of the step find it.
  const count = wanted > 1 ? min<f64>(wanted, MAX_SUBSTEPS) : 1;
  const h = dt / count;
  for (let i: f64 = 0; i < count; i++) rotateByMidpoint(0.5 * h);
}

// Solves I (m - omega) + half m x (I m) = 0 for the angular velocity m in the middle of a sub-step by Newton's method.
function rotateByMidpoint(half: f64): void {
  // Differences of the moments: the components of m x (I m) are dx my mz, dy mz mx, dz mx my.
  const dx = half * (iz - iy);
  const dy = half * (ix - iz);
  const dz = half * (iy - ix);
  let x = wx;
  let y = wy;
  let z = wz;
  for (let i = 0; i < MAX_ITERATIONS; i++) {
    const rx = ix * (x - wx) + dx * y * z;
    const ry = iy * (y - wy) + dy * z * x;
    const rz = iz * (z - wz) + dz * x * y;
    // The Jacobian: rows (ix, a, b), (c, iy, d), (e, f, iz).
    const a = dx * z;
    const b = dx * y;
    const c = dy * z;
    const d = dy * x;
    const e = dz * y;
    const f = dz * x;
    const p = iy * iz - d * f;
    const q = d * e - c * iz;
    const r = c * f - iy * e;
    const scale = 1 / (ix * p + a * q + b * r);
    const sx = scale * (p * rx + (b * f - a * iz) * ry + (a * d - b * iy) * rz);
    const sy = scale * (q * rx + (ix * iz - b * e) * ry + (b * c - ix * d) * rz);
    const sz = scale * (r * rx + (a * e - ix * f) * ry + (ix * iy - a * c) * rz);
    x -= sx;
    y -= sy;
    z -= sz;
    if (sx * sx + sy * sy + sz * sz <= TOLERANCE * (x * x + y * y + z * z)) break;
  }
  const cx = half * x;
  const cy = half * y;
  const cz = half * z;
  const norm = 1 / sqrt<f64>(1 + cx * cx + cy * cy + cz * cz);
  rotateBy(cx * norm, cy * norm, cz * norm, norm);
}
