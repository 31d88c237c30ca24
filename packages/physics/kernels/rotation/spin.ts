// Energy and angular momentum of rotation where bodies have an inertia tensor, in f64 and ascending id.
import { hasTensor } from '../dynamics/has-tensor';
import { columns } from '../memory/columns';
import { rotatedX } from './rotate-vector';
import { get, ix, iy, iz, loadBody, qw, qx, qy, qz, wx, wy, wz } from './tensor-body';

// Sum of omega . L / 2, J.
export function spinEnergy(first: i32, last: i32): f64 {
  const c = columns();
  let sum: f64 = 0;
  for (let row = first; row < last; row++) {
    if (hasTensor(row)) {
      if (loadBody(row)) sum += 0.5 * (ix * wx * wx + iy * wy * wy + iz * wz * wz);
      continue;
    }
    const x: f64 = get(c.angularVelocityX, row);
    const y: f64 = get(c.angularVelocityY, row);
    const z: f64 = get(c.angularVelocityZ, row);
    sum += 0.5 * get(c.inertia, row) * (x * x + y * y + z * z);
  }
  return sum;
}

// Sum of one component of L = R I R^T omega, axis 0, 1 or 2 in the world, kg m^2/s.
export function spinMomentum(axis: i32, first: i32, last: i32): f64 {
  const c = columns();
  const omega = axis == 0 ? c.angularVelocityX : axis == 1 ? c.angularVelocityY : c.angularVelocityZ;
  let sum: f64 = 0;
  for (let row = first; row < last; row++) {
    if (!hasTensor(row)) sum += get(c.inertia, row) * get(omega, row);
    else if (loadBody(row)) sum += momentumAlong(axis);
  }
  return sum;
}

function momentumAlong(axis: i32): f64 {
  if (axis == 0) return rotatedX(qx, qy, qz, qw, ix * wx, iy * wy, iz * wz);
  if (axis == 1) return rotatedX(qy, qz, qx, qw, iy * wy, iz * wz, ix * wx);
  return rotatedX(qz, qx, qy, qw, iz * wz, ix * wx, iy * wy);
}
