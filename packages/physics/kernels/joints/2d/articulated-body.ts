// A body of a tree of joints. Its mass matrix over x, y and angle with all that hangs below it, or the inverse of that, stands
// beside it: hinges read it once a sub-step.
import { JointTable } from './joint-table';

@unmanaged
export class ArticulatedBody {
  // Momentum of what hangs below it, then the velocity that it gets.
  gx: f64;
  gy: f64;
  gw: f64;
  vx: f64;
  vy: f64;
  w: f64;
  // Its own mass and moment of inertia; a body that may not turn has a large one.
  mass: f64;
  inertia: f64;
}

// The upper half of a symmetric matrix: what hangs below a body, until the joint above it adds the body itself.
@unmanaged
export class ArticulatedMass {
  m00: f64;
  m01: f64;
  m02: f64;
  m11: f64;
  m12: f64;
  m22: f64;
}

export const ARTICULATED_BODY_SIZE: usize = offsetof<ArticulatedBody>();
export const ARTICULATED_MASS_SIZE: usize = offsetof<ArticulatedMass>();

// @ts-ignore: decorator
@inline export function articulated(t: JointTable, index: i32): ArticulatedBody {
  return changetype<ArticulatedBody>(t.bodies + <usize>index * ARTICULATED_BODY_SIZE);
}

// @ts-ignore: decorator
@inline export function massOf(t: JointTable, index: i32): ArticulatedMass {
  return changetype<ArticulatedMass>(t.masses + <usize>index * ARTICULATED_MASS_SIZE);
}

// The matrix of a body: 48 bytes for 64.
// @ts-ignore: decorator
@inline export function massBeside(t: JointTable, body: usize): ArticulatedMass {
  return changetype<ArticulatedMass>(t.masses + ((body - t.bodies) >> 2) * 3);
}

// Adds the mass of a body itself to what hangs below it.
// @ts-ignore: decorator
@inline export function addOwnMass(to: ArticulatedMass, body: ArticulatedBody): void {
  to.m00 += body.mass;
  to.m11 += body.mass;
  to.m22 += body.inertia;
}

// Adds an impulse to the momentum of a body of a tree; `at` is 0 for one that joints do not move.
export function pushBody(at: usize, x: f64, y: f64, turn: f64): void {
  if (at == 0) return;
  const body = changetype<ArticulatedBody>(at);
  body.gx += x;
  body.gy += y;
  body.gw += turn;
}

// Turns the momentum of a body with the velocity (vx, vy, w) and of what hangs below it into the velocity that it gets, with
// the inverse of its matrix, and makes it ready for the next.
export function freeVelocity(body: ArticulatedBody, to: ArticulatedMass, vx: f64, vy: f64, w: f64): void {
  const x = body.gx + body.mass * vx;
  const y = body.gy + body.mass * vy;
  const turn = body.gw + body.inertia * w;
  body.gx = 0;
  body.gy = 0;
  body.gw = 0;
  body.vx = to.m00 * x + to.m01 * y + to.m02 * turn;
  body.vy = to.m01 * x + to.m11 * y + to.m12 * turn;
  body.w = to.m02 * x + to.m12 * y + to.m22 * turn;
}

// Six numbers of the upper half of a symmetric positive definite matrix of 3 × 3, replaced by those of its inverse, by
// L D Lᵀ. Cofactors would cancel: a joint to what does not move is ten thousand times as stiff along one direction as along
// the others. A direction without mass gets none in the inverse.
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
