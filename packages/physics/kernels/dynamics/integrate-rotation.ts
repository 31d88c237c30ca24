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

// 3D: q += dt/2 (omega) q, renormalised; a row with a zero quaternion and no angular velocity stays unchanged. Source:
// Kuipers, Quaternions and Rotation Sequences, section 11.4 (first order in dt; the norm is restored each step).
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
    const ax = load<real>(wx + o) * half;
    const ay = load<real>(wy + o) * half;
    const az = load<real>(wz + o) * half;
    if (ax == 0 && ay == 0 && az == 0) continue;
    const x = load<real>(qx + o);
    const y = load<real>(qy + o);
    const z = load<real>(qz + o);
    let w = load<real>(qw + o);
    if (x == 0 && y == 0 && z == 0 && w == 0) w = 1;
    const nx = x + ax * w + ay * z - az * y;
    const ny = y + ay * w + az * x - ax * z;
    const nz = z + az * w + ax * y - ay * x;
    const nw = w - ax * x - ay * y - az * z;
    const scale = <real>1 / sqrt<real>(nx * nx + ny * ny + nz * nz + nw * nw);
    store<real>(qx + o, nx * scale);
    store<real>(qy + o, ny * scale);
    store<real>(qz + o, nz * scale);
    store<real>(qw + o, nw * scale);
  }
}
