// A joint of this step. Each direction in which it acts is a row of the Jacobian: with the vector d and the arms of both
// bodies, its speed is d · (v_b - v_a) + arm_b ω_b - arm_a ω_a. The locked directions of a hinge are x and y: they follow
// from the anchors and have no rows (hinge-locks.ts).
import { JointTable, REVOLUTE } from './joint-table';

@unmanaged
export class JointRow {
  x: f64;
  y: f64;
  armA: f64;
  armB: f64;
  // How far the direction is from where it should be, m or rad.
  error: f64;
  // Of a locked direction: an intermediate of the solution.
  value: f64;
}

@unmanaged
export class JointWork {
  id: i32;
  // Rows of the bodies' states, 0 for one that does not move, and of their poses.
  a: i32;
  b: i32;
  rowA: i32;
  rowB: i32;
  // Number of locked directions.
  locks: i32;
  // In a tree: 1 where a is the parent, 2 where b is, 0 for a joint that closes a loop.
  parent: i32;
  kind: u32;
  // 1 with a spring, a motor or limits, and for motor joints, pulleys and gears.
  hasAxes: i32;
  // Rows, class JointRow: three locked ones, that of spring and limits, and that of the motor.
  rows: usize;
  massA: f64;
  inertiaA: f64;
  massB: f64;
  inertiaB: f64;
  // The inverse of the effective mass matrix of the locked directions, by rows of its upper half.
  i00: f64;
  i01: f64;
  i02: f64;
  i11: f64;
  i12: f64;
  i22: f64;
  // Anchors from the centres of both bodies, in the axes of the world, and from the anchor of a to that of b, m.
  rax: f64;
  ray: f64;
  rbx: f64;
  rby: f64;
  dx: f64;
  dy: f64;
  // Of a hinge: an intermediate of the solution, as `value` of a row, and what it has exerted: JointImpulses keeps it from
  // step to step only.
  valueX: f64;
  valueY: f64;
  impulseX: f64;
  impulseY: f64;
  // Largest impulse of a sub-step, squared, and largest angular impulse.
  largest: f64;
  largestTurn: f64;
  // Anchors in the axes of the bodies.
  localAx: f64;
  localAy: f64;
  localBx: f64;
  localBy: f64;
}

const ROW: usize = 48;
const ROWS: usize = 5 * ROW;
const SIZE: usize = offsetof<JointWork>();

export const SPRING_ROW: i32 = 3;
export const MOTOR_ROW: i32 = 4;

// @ts-ignore: decorator
@inline export function workAt(t: JointTable, i: i32): JointWork {
  return changetype<JointWork>(t.works + <usize>i * SIZE);
}

// Everything but the rows is zero, and the rows are those of before.
// @ts-ignore: decorator
@inline export function clearWork(t: JointTable, i: i32): JointWork {
  const work = workAt(t, i);
  memory.fill(changetype<usize>(work), 0, SIZE);
  work.rows = t.rows + <usize>i * ROWS;
  return work;
}

// @ts-ignore: decorator
@inline export function clearRows(work: JointWork): void {
  memory.fill(work.rows, 0, ROWS);
}

// @ts-ignore: decorator
@inline export function isHinge(work: JointWork): bool {
  return work.kind == REVOLUTE;
}

// @ts-ignore: decorator
@inline export function rowOf(work: JointWork, i: i32): JointRow {
  return changetype<JointRow>(work.rows + <usize>i * ROW);
}

// The row of a body in trees: 0 for what joints do not move.
// @ts-ignore: decorator
@inline export function nodeA(work: JointWork): i32 {
  return work.massA > 0 ? work.a : 0;
}

// @ts-ignore: decorator
@inline export function nodeB(work: JointWork): i32 {
  return work.massB > 0 ? work.b : 0;
}

// The child in a tree, 0 where it does not move; a joint that closes a loop has none.
// @ts-ignore: decorator
@inline export function childOf(work: JointWork): i32 {
  return work.parent == 0 ? 0 : work.parent == 1 ? nodeB(work) : nodeA(work);
}

// @ts-ignore: decorator
@inline export function parentOf(work: JointWork): i32 {
  return work.parent == 1 ? nodeA(work) : nodeB(work);
}
