// Rotation of bodies with one moment of inertia by semi-implicit (symplectic) Euler: omega += torque/I dt, then the angle
// with the new omega. Bodies with an inertia tensor are left to kernels/rotation.
import { columns } from '../memory/columns';
import { at } from '../memory/lanes';
import { hasTensor } from './has-tensor';

// omega += torque/I dt about one axis, for rows with inertia and AngularVelocity.
export function kickSpinAxis(omega: usize, torque: usize, skipsTensors: bool, dt: real, first: i32, last: i32): void {
  const c = columns();
  const inertia = c.inertia;
  const members = c.members;
  const bit = c.angularVelocityBit;
  for (let row = first; row < last; row++) {
    const o = at(row);
    const i = load<real>(inertia + o);
    if (!(i > 0) || (load<u32>(members + ((<usize>row) << 2)) & bit) == 0) continue;
    if (skipsTensors && hasTensor(row)) continue;
    store<real>(omega + o, load<real>(omega + o) + (load<real>(torque + o) / i) * dt);
  }
}

// 3D: q becomes (cos a, n sin a) q, where a = |omega| dt/2 and n is the axis: exact for an angular velocity that stays, and
// renormalised because of rounding. A row with a zero quaternion and no angular velocity stays unchanged. Source: Kuipers,
// Quaternions and Rotation Sequences, section 5.15.
export function rotateQuaternion(dt: real, skipsTensors: bool, first: i32, last: i32): void {
  const c = columns();
  const qx = c.orientationX;
  const qy = c.orientationY;
  const qz = c.orientationZ;
  const qw = c.orientationW;
  const wx = c.angularVelocityX;
  const wy = c.angularVelocityY;
  const wz = c.angularVelocityZ;
  const half = <real>0.5 * dt;
  for (let row = first; row < last; row++) {
    if (skipsTensors && hasTensor(row)) continue;
    const o = at(row);
    let ax = load<real>(wx + o) * half;
    let ay = load<real>(wy + o) * half;
    let az = load<real>(wz + o) * half;
    if (ax == 0 && ay == 0 && az == 0) continue;
    turnBy(ax * ax + ay * ay + az * az);
    ax *= sinc;
    ay *= sinc;
    az *= sinc;
    const x = load<real>(qx + o);
    const y = load<real>(qy + o);
    const z = load<real>(qz + o);
    let w = load<real>(qw + o);
    if (x == 0 && y == 0 && z == 0 && w == 0) w = 1;
    const nx = cosine * x + ax * w + ay * z - az * y;
    const ny = cosine * y + ay * w + az * x - ax * z;
    const nz = cosine * z + az * w + ax * y - ay * x;
    const nw = cosine * w - ax * x - ay * y - az * z;
    const scale = <real>1 / sqrt<real>(nx * nx + ny * ny + nz * nz + nw * nw);
    store<real>(qx + o, nx * scale);
    store<real>(qy + o, ny * scale);
    store<real>(qz + o, nz * scale);
    store<real>(qw + o, nw * scale);
  }
}

// Results of `turnBy`: cos a, and (sin a)/a.
let cosine: real = 1;
let sinc: real = 1;

// Their Taylor series up to a = 1/4, where the next terms are below the rounding of f64, and beyond by doubling the angle.
function turnBy(square: real): void {
  let u = square;
  let doublings = 0;
  for (; u > 0.0625 && doublings < 60; doublings++) u *= 0.25;
  cosine = <real>1 - (u / 2) * (<real>1 - (u / 12) * (<real>1 - (u / 30) * (<real>1 - (u / 56) * (<real>1 - u / 90))));
  sinc = <real>1 - (u / 6) * (<real>1 - (u / 20) * (<real>1 - (u / 42) * (<real>1 - (u / 72) * (<real>1 - u / 110))));
  for (; doublings > 0; doublings--) {
    sinc *= cosine;
    cosine = <real>2 * cosine * cosine - 1;
  }
}
