// A body of a tree of joints: its mass matrix with all that hangs below it, or the inverse of that, over x, y and angle.
import { JointTable } from './joint-table';

@unmanaged
export class ArticulatedBody {
  // The upper half of a symmetric matrix.
  m00: f64;
  m01: f64;
  m02: f64;
  m11: f64;
  m12: f64;
  m22: f64;
  // Generalized force; then the change of velocity.
  fx: f64;
  fy: f64;
  fw: f64;
  // Torque by which pulling joints turn the body back, times the length of a sub-step, for each radian, N m s.
  stiffness: f64;
}

export const ARTICULATED_BODY_SIZE: usize = 80;

// @ts-ignore: decorator
@inline export function articulated(t: JointTable, row: i32): ArticulatedBody {
  return changetype<ArticulatedBody>(t.bodies + <usize>row * ARTICULATED_BODY_SIZE);
}

// A body that may not turn has this many times its mass as inertia, kg m²: enough digits are left.
const LOCKED_INERTIA: f64 = 1e8;

export function startBody(t: JointTable, row: i32, inverseMass: f64, inverseInertia: f64): void {
  const body = articulated(t, row);
  body.m00 = 1 / inverseMass;
  body.m01 = 0;
  body.m02 = 0;
  body.m11 = body.m00;
  body.m12 = 0;
  body.fx = 0;
  body.fy = 0;
  body.fw = 0;
  body.m22 = inverseInertia > 0 ? 1 / inverseInertia : LOCKED_INERTIA * body.m00;
}

// Forgets what acts on a body.
export function clearBody(t: JointTable, row: i32): void {
  const body = articulated(t, row);
  body.fx = 0;
  body.fy = 0;
  body.fw = 0;
  body.stiffness = 0;
}

// Six numbers of the upper half of a symmetric matrix of 3 × 3, replaced by those of its inverse; zero if there is none.
export function invert(matrix: usize): void {
  const a = load<f64>(matrix);
  const b = load<f64>(matrix, 8);
  const c = load<f64>(matrix, 16);
  const d = load<f64>(matrix, 24);
  const e = load<f64>(matrix, 32);
  const f = load<f64>(matrix, 40);
  const A = d * f - e * e;
  const B = c * e - b * f;
  const C = b * e - c * d;
  const determinant = a * A + b * B + c * C;
  const k = determinant != 0 ? 1 / determinant : 0;
  store<f64>(matrix, A * k);
  store<f64>(matrix, B * k, 8);
  store<f64>(matrix, C * k, 16);
  store<f64>(matrix, (a * f - c * c) * k, 24);
  store<f64>(matrix, (b * c - a * e) * k, 32);
  store<f64>(matrix, (a * d - b * b) * k, 40);
}
