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
  // Generalized force that is left for the body to bear, and its change of velocity by it.
  gx: f64;
  gy: f64;
  gw: f64;
  fx: f64;
  fy: f64;
  fw: f64;
  // Torque by which pulling joints turn the body back, times the length of a sub-step, for each radian, N m s.
  stiffness: f64;
}

export const ARTICULATED_BODY_SIZE: usize = offsetof<ArticulatedBody>();

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
  body.m22 = inverseInertia > 0 ? 1 / inverseInertia : LOCKED_INERTIA * body.m00;
}

// Forgets what acts on a body.
export function clearBody(t: JointTable, row: i32): void {
  const body = articulated(t, row);
  body.gx = 0;
  body.gy = 0;
  body.gw = 0;
  body.stiffness = 0;
}

// Turns the force on a body into its change of velocity, with the inverse of its matrix, and makes it ready for the next.
// @ts-ignore: decorator
@inline export function accelerate(body: ArticulatedBody): void {
  const x = body.gx;
  const y = body.gy;
  const w = body.gw;
  body.gx = 0;
  body.gy = 0;
  body.gw = 0;
  body.stiffness = 0;
  body.fx = body.m00 * x + body.m01 * y + body.m02 * w;
  body.fy = body.m01 * x + body.m11 * y + body.m12 * w;
  body.fw = body.m02 * x + body.m12 * y + body.m22 * w;
}

// Six numbers of the upper half of a symmetric positive definite matrix of 3 × 3, replaced by those of its inverse, by
// L D Lᵀ. Cofactors would cancel: a joint to what does not move is a million times as stiff along one direction as along the
// others, and of a rod they leave no digit. A direction without mass gets none in the inverse.
// Source: Golub and Van Loan, Matrix Computations, section 4.1.
export function invert(matrix: usize): void {
  const a = load<f64>(matrix);
  const b = load<f64>(matrix, 8);
  const c = load<f64>(matrix, 16);
  const p0 = reciprocal(a);
  const l10 = b * p0;
  const l20 = c * p0;
  const p1 = reciprocal(load<f64>(matrix, 24) - l10 * b);
  const e = load<f64>(matrix, 32) - l10 * c;
  const l21 = e * p1;
  const p2 = reciprocal(load<f64>(matrix, 40) - l20 * c - l21 * e);
  // The last row of the inverse of L is (s, -l21, 1).
  const s = l10 * l21 - l20;
  const q = l21 * p2;
  store<f64>(matrix, p0 + l10 * l10 * p1 + s * s * p2);
  store<f64>(matrix, -l10 * p1 - s * q, 8);
  store<f64>(matrix, s * p2, 16);
  store<f64>(matrix, p1 + l21 * q, 24);
  store<f64>(matrix, -q, 32);
  store<f64>(matrix, p2, 40);
}

// @ts-ignore: decorator
@inline function reciprocal(pivot: f64): f64 {
  return pivot > 0 ? 1 / pivot : 0;
}
