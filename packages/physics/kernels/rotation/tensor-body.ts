// One body with an inertia tensor: orientation, angular velocity in the body's axes, and principal moments, in f64 for
// worlds of both precisions. A kernel loads a row into these variables, because functions of kernels return one number.
import { columns } from '../memory/columns';
import { rotatedX } from './rotate-vector';

export let qx: f64 = 0;
export let qy: f64 = 0;
export let qz: f64 = 0;
export let qw: f64 = 1;
export let wx: f64 = 0;
export let wy: f64 = 0;
export let wz: f64 = 0;
export let ix: f64 = 1;
export let iy: f64 = 1;
export let iz: f64 = 1;

// Reads a row of a column of reals of either precision.
export function get(column: usize, row: i32): f64 {
  if (columns().realBytes == 4) return <f64>load<f32>(column + ((<usize>row) << 2));
  return load<f64>(column + ((<usize>row) << 3));
}

function put(column: usize, row: i32, value: f64): void {
  if (columns().realBytes == 4) store<f32>(column + ((<usize>row) << 2), <f32>value);
  else store<f64>(column + ((<usize>row) << 3), value);
}

// Loads a row. Moments that are not positive, which only a column can hold, become equal ones: no torque of the body
// then changes its rotation, as without Inertia. Returns whether the moments are valid.
export function loadBody(row: i32): bool {
  const c = columns();
  qx = get(c.orientationX, row);
  qy = get(c.orientationY, row);
  qz = get(c.orientationZ, row);
  qw = get(c.orientationW, row);
  if (qx == 0 && qy == 0 && qz == 0 && qw == 0) qw = 1;
  const x: f64 = get(c.angularVelocityX, row);
  const y: f64 = get(c.angularVelocityY, row);
  const z: f64 = get(c.angularVelocityZ, row);
  wx = rotatedX(qx, qy, qz, -qw, x, y, z);
  wy = rotatedX(qy, qz, qx, -qw, y, z, x);
  wz = rotatedX(qz, qx, qy, -qw, z, x, y);
  ix = get(c.inertiaTensorX, row);
  iy = get(c.inertiaTensorY, row);
  iz = get(c.inertiaTensorZ, row);
  if (ix > 0 && iy > 0 && iz > 0 && ix < Infinity && iy < Infinity && iz < Infinity) return true;
  ix = iy = iz = 1;
  return false;
}

// Stores orientation and angular velocity.
export function storeBody(row: i32): void {
  const c = columns();
  put(c.orientationX, row, qx);
  put(c.orientationY, row, qy);
  put(c.orientationZ, row, qz);
  put(c.orientationW, row, qw);
  put(c.angularVelocityX, row, rotatedX(qx, qy, qz, qw, wx, wy, wz));
  put(c.angularVelocityY, row, rotatedX(qy, qz, qx, qw, wy, wz, wx));
  put(c.angularVelocityZ, row, rotatedX(qz, qx, qy, qw, wz, wx, wy));
}

// Adds an impulse of torque, N m s, in the world's axes: omega += I^-1 R^T impulse.
export function addTorque(x: f64, y: f64, z: f64): void {
  wx += rotatedX(qx, qy, qz, -qw, x, y, z) / ix;
  wy += rotatedX(qy, qz, qx, -qw, y, z, x) / iy;
  wz += rotatedX(qz, qx, qy, -qw, z, x, y) / iz;
}

// Multiplies the orientation by the rotation (x, y, z, w) in the body's axes, and rotates the angular momentum back, so
// that it stays the same in the world. (x, y, z, w) has length 1.
export function rotateBy(x: f64, y: f64, z: f64, w: f64): void {
  const lx = ix * wx;
  const ly = iy * wy;
  const lz = iz * wz;
  wx = rotatedX(x, y, z, -w, lx, ly, lz) / ix;
  wy = rotatedX(y, z, x, -w, ly, lz, lx) / iy;
  wz = rotatedX(z, x, y, -w, lz, lx, ly) / iz;
  const nx = qw * x + qx * w + qy * z - qz * y;
  const ny = qw * y + qy * w + qz * x - qx * z;
  const nz = qw * z + qz * w + qx * y - qy * x;
  const nw = qw * w - qx * x - qy * y - qz * z;
  const scale = 1 / sqrt<f64>(nx * nx + ny * ny + nz * nz + nw * nw);
  qx = nx * scale;
  qy = ny * scale;
  qz = nz * scale;
  qw = nw * scale;
}
