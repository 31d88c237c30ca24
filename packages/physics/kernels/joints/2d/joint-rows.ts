// Speed and impulse along a row of a joint.
import { BodyState, stateOf } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { JointImpulses, lockAddress } from './joint-table';
import { JointRow, JointWork, MOST_LOCKS, rowOf } from './joint-work';

export function speedAlong(a: BodyState, b: BodyState, row: JointRow): f64 {
  const linear = row.x * (<f64>b.vx - <f64>a.vx) + row.y * (<f64>b.vy - <f64>a.vy);
  return linear + row.armB * <f64>b.w - row.armA * <f64>a.w;
}

// Applies an impulse to b along a row, and its opposite to a. Bodies without mass keep their velocities.
export function applyAlong(work: JointWork, a: BodyState, b: BodyState, row: JointRow, impulse: f64): void {
  a.vx = <real>(<f64>a.vx - impulse * work.massAx * row.x);
  a.vy = <real>(<f64>a.vy - impulse * work.massAy * row.y);
  a.w = <real>(<f64>a.w - work.inertiaA * row.armA * impulse);
  b.vx = <real>(<f64>b.vx + impulse * work.massBx * row.x);
  b.vy = <real>(<f64>b.vy + impulse * work.massBy * row.y);
  b.w = <real>(<f64>b.w + work.inertiaB * row.armB * impulse);
}

// Applies the impulses of the three locked directions together. The rows of a joint with fewer of them are zero.
export function applyLocks(work: JointWork, a: BodyState, b: BodyState, j0: f64, j1: f64, j2: f64): void {
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  const x = j0 * r0.x + j1 * r1.x + j2 * r2.x;
  const y = j0 * r0.y + j1 * r1.y + j2 * r2.y;
  const turnA = j0 * r0.armA + j1 * r1.armA + j2 * r2.armA;
  const turnB = j0 * r0.armB + j1 * r1.armB + j2 * r2.armB;
  a.vx = <real>(<f64>a.vx - work.massAx * x);
  a.vy = <real>(<f64>a.vy - work.massAy * y);
  a.w = <real>(<f64>a.w - work.inertiaA * turnA);
  b.vx = <real>(<f64>b.vx + work.massBx * x);
  b.vy = <real>(<f64>b.vy + work.massBy * y);
  b.w = <real>(<f64>b.w + work.inertiaB * turnB);
}

// What one row and another have to do with each other through the masses of both bodies, 1/kg: an element of J M⁻¹ Jᵀ.
export function coupling(work: JointWork, p: JointRow, q: JointRow): f64 {
  const linear = (work.massAx + work.massBx) * (p.x * q.x) + (work.massAy + work.massBy) * (p.y * q.y);
  return linear + work.inertiaA * p.armA * q.armA + work.inertiaB * p.armB * q.armB;
}

// @ts-ignore: decorator
@inline export function stateA(rigid: RigidTable, work: JointWork): BodyState {
  return stateOf(rigid, work.a);
}

// @ts-ignore: decorator
@inline export function stateB(rigid: RigidTable, work: JointWork): BodyState {
  return stateOf(rigid, work.b);
}

// No impulse is larger, N s: what is not finite would reach every body of a chain.
const MAX_IMPULSE: f64 = 1e30;

// @ts-ignore: decorator
@inline export function finite(impulse: f64): f64 {
  return abs<f64>(impulse) < MAX_IMPULSE ? impulse : 0;
}

// @ts-ignore: decorator
@inline export function finiteVector(impulse: v128): v128 {
  return v128.and(impulse, f64x2.lt(f64x2.abs(impulse), f64x2.splat(MAX_IMPULSE)));
}

// Joints that are farther apart, m or rad, come together as if they were so far apart: at the rate at which gaps close, a few metres
// would take a speed that whatever touches a body keeps. Source: Box2D 2 (b2_maxLinearCorrection).
export const MOST_ERROR: f64 = 0.1;

// @ts-ignore: decorator
@inline export function bounded(error: f64): f64 {
  return min<f64>(MOST_ERROR, max<f64>(-MOST_ERROR, error));
}

// @ts-ignore: decorator
@inline export function boundedVector(error: v128): v128 {
  return f64x2.min(f64x2.splat(MOST_ERROR), f64x2.max(f64x2.splat(-MOST_ERROR), error));
}

export function setRow(row: JointRow, x: f64, y: f64, armA: f64, armB: f64, error: f64, chord: f64): void {
  row.x = x;
  row.y = y;
  row.armA = armA;
  row.armB = armB;
  row.error = error;
  row.chord = chord;
}

// Makes a direction of a joint one of its locked ones for this sub-step, as a limit or a motor does. Returns its number, -1 if there is
// no row left for it.
export function addLock(work: JointWork, from: JointRow, error: f64, chord: f64): i32 {
  let lock = work.ownLocks;
  while (lock < work.locks && !isEmpty(rowOf(work, lock))) lock++;
  if (lock >= MOST_LOCKS) return -1;
  setRow(rowOf(work, lock), from.x, from.y, from.armA, from.armB, error, chord);
  work.locks = max<i32>(work.locks, lock + 1);
  return lock;
}

// Takes it out again. Its row stays, without a direction, as long as there is another one behind it.
export function removeLock(work: JointWork, impulses: JointImpulses, lock: i32): void {
  memory.fill(changetype<usize>(rowOf(work, lock)), 0, offsetof<JointRow>());
  store<f64>(lockAddress(impulses, lock), 0);
  while (work.locks > work.ownLocks && isEmpty(rowOf(work, work.locks - 1))) work.locks--;
}

// @ts-ignore: decorator
@inline function isEmpty(row: JointRow): bool {
  return row.x == 0 && row.y == 0 && row.armA == 0 && row.armB == 0;
}
