// Forces of a fluid on round bodies and wings. In 2D every z is zero and the same lines serve.
import { columns, get, put } from '../columns';
import { power } from '../math/power';

// Drag of a sphere of the collider's radius at any Reynolds number Re = 2 r density |w| / viscosity:
//   Cd = 24/Re (1 + 0.15 Re^0.687) + 0.42 / (1 + 42500 Re^-1.16)
// written so that Re = 0 is Stokes' law and not 0/0.
export function sphereDrag(
  fx: usize,
  fy: usize,
  fz: usize,
  density: f64,
  viscosity: f64,
  wx: f64,
  wy: f64,
  wz: f64,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let row = first; row < last; row++) {
    const r = <f64>get(c.radius, row);
    if (!(r > 0)) continue;
    const x = <f64>get(c.velocityX, row) - wx;
    const y = <f64>get(c.velocityY, row) - wy;
    const z = <f64>get(c.velocityZ, row) - wz;
    const speed = sqrt<f64>(x * x + y * y + z * z);
    if (!(speed > 0)) continue;
    const reynolds = (2 * r * density * speed) / viscosity;
    const slow = 18.84955592153876 * viscosity * r * (1 + 0.15 * power(reynolds, 0.687));
    const fast = 0.6597344572538566 * density * r * r * speed;
    const k = slow + fast / (1 + 42500 * power(reynolds, -1.16));
    put(fx, row, get(fx, row) - <real>(k * x));
    put(fy, row, get(fy, row) - <real>(k * y));
    put(fz, row, get(fz, row) - <real>(k * z));
  }
}

// F += k |w| (s x w) with the span axis s and the velocity w through the medium; s turns with the body where `turned`.
export function liftForce(
  fx: usize,
  fy: usize,
  fz: usize,
  coefficient: usize,
  qx: usize,
  qy: usize,
  qz: usize,
  qw: usize,
  turned: i32,
  sx: real,
  sy: real,
  sz: real,
  wx: real,
  wy: real,
  wz: real,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let row = first; row < last; row++) {
    const k = get(coefficient, row);
    if (k == 0) continue;
    const x = get(c.velocityX, row) - wx;
    const y = get(c.velocityY, row) - wy;
    const z = get(c.velocityZ, row) - wz;
    let ax = sx;
    let ay = sy;
    let az = sz;
    if (turned != 0) {
      const ux = get(qx, row);
      const uy = get(qy, row);
      const uz = get(qz, row);
      const w = get(qw, row);
      const tx = <real>2 * (uy * sz - uz * sy);
      const ty = <real>2 * (uz * sx - ux * sz);
      const tz = <real>2 * (ux * sy - uy * sx);
      ax = sx + w * tx + uy * tz - uz * ty;
      ay = sy + w * ty + uz * tx - ux * tz;
      az = sz + w * tz + ux * ty - uy * tx;
    }
    const size = k * sqrt<real>(x * x + y * y + z * z);
    put(fx, row, get(fx, row) + size * (ay * z - az * y));
    put(fy, row, get(fy, row) + size * (az * x - ax * z));
    put(fz, row, get(fz, row) + size * (ax * y - ay * x));
  }
}

// F += k r^3 (omega x w): k = pi times density for a sphere.
export function magnusForce(
  fx: usize,
  fy: usize,
  fz: usize,
  k: real,
  wx: real,
  wy: real,
  wz: real,
  first: i32,
  last: i32,
): void {
  const c = columns();
  for (let row = first; row < last; row++) {
    const r = get(c.radius, row);
    if (r == 0) continue;
    const size = k * r * r * r;
    const x = get(c.velocityX, row) - wx;
    const y = get(c.velocityY, row) - wy;
    const z = get(c.velocityZ, row) - wz;
    const ox = get(c.angularVelocityX, row);
    const oy = get(c.angularVelocityY, row);
    const oz = get(c.angularVelocityZ, row);
    put(fx, row, get(fx, row) + size * (oy * z - oz * y));
    put(fy, row, get(fy, row) + size * (oz * x - ox * z));
    put(fz, row, get(fz, row) + size * (ox * y - oy * x));
  }
}
