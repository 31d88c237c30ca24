// Rotation of bodies with an inertia tensor, Euler's equations of a rigid body.
//
//   dL/dt = torque, L = R I R^T omega        in the body's axes:  I domega/dt = torque - omega x (I omega)
//
// Free rotation by the implicit midpoint rule in the body's axes and a Cayley map of the orientation, which together
// keep the angular momentum in the world and the energy exactly and are reversed by -dt. Sources: Simo and Wong,
// Unconditionally stable algorithms for rigid body dynamics that exactly preserve energy and momentum, Int. J. Numer.
// Meth. Engng 31 (1991), 19-52; Austin, Krishnaprasad and Wang, Almost Poisson integration of rigid body systems,
// J. Comput. Phys. 107 (1993), 105-117.
//
// Because both are kept, the error of second order can only be one of time along the exact path of omega, and one of
// rotation about L. A step of h moves omega as far as exact rotation does in h (1 + h^2 s), and turns the body too far by
// the vector h^3 r L, where
//
//   12 s = sum of (Iz - Ix) (Ix - Iy) / (Iy Iz) wx^2 over cyclic permutations       in the middle of the step
//   12 r = (2 L^2 - 2 E (Ix + Iy + Iz)) / (Ix Iy Iz),  E the kinetic energy         constant
//
// With a step that is shorter by h^2 s and a rotation back the scheme has order 4, and still keeps both. The idea is that of Hairer and
// Vilmart, Preprocessed discrete Moser-Veselov algorithm for the full dynamics of a rigid body, J. Phys. A 39 (2006),
// 13225-13235; the terms follow from the modified equation of the midpoint rule (Hairer, Lubich and Wanner, Geometric
// Numerical Integration, IX.1) and the Magnus series of the orientation.
import { hasTensor } from '../dynamics/has-tensor';
import { addTorque, get, ix, iy, iz, loadBody, rotateBy, storeBody, wx, wy, wz } from './tensor-body';

// Angle that a sub-step may rotate, rad: it errs by some 1e-6 of the angle.
const MAX_ANGLE: f64 = 0.1;
const MAX_SUBSTEPS: f64 = 64;
// Part to which a sub-step may be shortened. Only one that rotates by a radian or more wants more.
const LEAST_PART: f64 = 0.9;
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
  turnBack(dt * h * h);
}

// Takes back the rotation about L that sub-steps of length h add in a time dt: `scale` is dt h^2. It commutes with theirs, and
// does not change L, so the quaternion needs no length of 1.
function turnBack(scale: f64): void {
  const lx = ix * wx;
  const ly = iy * wy;
  const lz = iz * wz;
  const excess = lx * lx + ly * ly + lz * lz - (lx * wx + ly * wy + lz * wz) * 0.5 * (ix + iy + iz);
  const half = (scale * excess) / (-12 * ix * iy * iz);
  rotateBy(half * lx, half * ly, half * lz, 1);
}

// Solves I (m - omega) + half m x (I m) = 0 for the angular velocity m in the middle of a sub-step by Newton's method.
function rotateByMidpoint(halfStep: f64): void {
  const ex = iz - iy;
  const ey = ix - iz;
  const ez = iy - ix;
  // s h^2 = lagX wx^2 + lagY wy^2 + lagZ wz^2
  const scale = (halfStep * halfStep) / (3 * ix * iy * iz);
  const lagX = scale * ix * ey * ez;
  const lagY = scale * iy * ez * ex;
  const lagZ = scale * iz * ex * ey;
  let half = halfStep;
  let x = wx;
  let y = wy;
  let z = wz;
  for (let i = 0; i < MAX_ITERATIONS; i++) {
    const lag = lagX * x * x + lagY * y * y + lagZ * z * z;
    half = halfStep * max<f64>(LEAST_PART, 1 - lag);
    // The components of m x (I m) are ex my mz, ey mz mx, ez mx my.
    const dx = half * ex;
    const dy = half * ey;
    const dz = half * ez;
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
    const inverse = 1 / (ix * p + a * q + b * r);
    const sx = inverse * (p * rx + (b * f - a * iz) * ry + (a * d - b * iy) * rz);
    const sy = inverse * (q * rx + (ix * iz - b * e) * ry + (b * c - ix * d) * rz);
    const sz = inverse * (r * rx + (a * e - ix * f) * ry + (ix * iy - a * c) * rz);
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
