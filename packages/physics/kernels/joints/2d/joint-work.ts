// A joint of this step. Each direction in which it acts is a row of the Jacobian: with the vector d and the arms of both
// bodies, its speed is d · (v_b - v_a) + arm_b ω_b - arm_a ω_a. The locked directions of a hinge are x and y: they follow
// from the anchors and have no rows (hinge-locks.ts).
import { JointTable } from './joint-table';

@unmanaged
export class JointRow {
  x: f64;
  y: f64;
  armA: f64;
  armB: f64;
  // How far the direction is from where it should be, m or rad.
  error: f64;
  // Its chord (chords.ts), m/s.
  chord: f64;
  // Of a locked direction: an intermediate of the solution.
  value: f64;
}

@unmanaged
export class JointWork {
  // As of JointPlace.
  parent: i32;
  id: i32;
  kind: u32;
  // Number of locked directions.
  locks: i32;
  // In a tree: which of its limits bears, 0 for none (engage-limits.ts).
  limit: i32;
  // The row of that limit among the locked directions.
  limitLock: i32;
  // Which bore last in this step.
  bore: i32;
  // What its motor does with its tree, 0 for nothing, and its row among the locked directions, -1 for none (engage-motors.ts).
  motor: i32;
  motorLock: i32;
  // How many directions it locks itself, before limits, motor and spring.
  ownLocks: i32;
  // The row of its spring among the locked directions, -1 for none (engage-springs.ts).
  springLock: i32;
  // How many springs that are solved one after another act on its bodies (count-springs.ts).
  springs: i32;
  // Whether its limit is passed, and comes back by itself.
  returns: i32;
  // What a motor that pushes and a spring add to the impulses on the tree in this pass, N s or N m s (push-axes.ts).
  push: f64;
  springPush: f64;
  // Of a spring among the locked directions: how much it gives way, 1/kg, and how fast its error is to go, m/s.
  give: f64;
  springBias: f64;
  // 1 with a spring, a motor or limits, and for motor joints, pulleys and gears.
  hasAxes: i32;
  // Rows of the states of a and b, 0 for one that does not move, and of their poses.
  a: i32;
  b: i32;
  rowA: i32;
  rowB: i32;
  // Rows, class JointRow: three locked ones, that of spring and limits, and that of the motor.
  rows: usize;
  // Inverse masses, 0 along a locked axis, and inverse moments of inertia.
  massAx: f64;
  massAy: f64;
  inertiaA: f64;
  massBx: f64;
  massBy: f64;
  inertiaB: f64;
  // The inverse of the effective mass matrix of the locked directions, by rows of its upper half.
  i00: f64;
  i01: f64;
  i02: f64;
  i11: f64;
  i12: f64;
  i22: f64;
  // Of a rod or a rope that is pulled hard: the inverse of what weighs across it (brace-rods.ts), 1/kg; else 0.
  acrossInverse: f64;
  // Part of its error that a sub-step corrects: less than 1 for a rod or a rope across what locks leave free (measure-joints.ts).
  reach: f64;
  // Anchors from the centres of both bodies, in the axes of the world, and from the anchor of a to that of b, m.
  rax: f64;
  ray: f64;
  rbx: f64;
  rby: f64;
  dx: f64;
  dy: f64;
  // For its chords (chords.ts): the bends of both bodies, the velocity of the anchor of b from that of a, m/s, the
  // angular velocity of a, rad/s, and the lesser half step of both, s.
  bendA: f64;
  bendB: f64;
  slideX: f64;
  slideY: f64;
  turning: f64;
  halfStep: f64;
  // Largest angular impulse of a sub-step.
  largestTurn: f64;
  // Anchors in the axes of the bodies.
  localAx: f64;
  localAy: f64;
  localBx: f64;
  localBy: f64;
  // Inverse masses along locked axes as the locked directions see them (prepare-joints.ts), 1/kg.
  railX: f64;
  railY: f64;
}

// Of a hinge when the step began: anchors from the centres of the parent and the child, in the axes of the world, and from the
// centre of the parent to that of the child, m. Then how fast the anchor of the child is to come to that of the parent, m/s: by the
// chord, and by what closes the gap.
@unmanaged
export class HingeStart {
  parentX: f64;
  parentY: f64;
  childX: f64;
  childY: f64;
  x: f64;
  y: f64;
  wantedX: f64;
  wantedY: f64;
  // Half steps of the parent and of the child (brace-joints.ts), s.
  halfStepParent: f64;
  halfStepChild: f64;
}

// What is read of a joint in every pass, side by side: its place in a tree, and a hinge (hinge-locks.ts).
@unmanaged
export class JointPlace {
  // Whether it is solved as a hinge of a tree: PLAIN, or WARM if it begins with what it exerted in the last sub-step, else 0.
  hinge: i32;
  // Whether the child may turn.
  turns: i32;
  // In a tree: the parent and the child, class ArticulatedBody, the child 0 if joints do not move it.
  above: usize;
  below: usize;
  id: i32;
  // In a tree: 1 where a is the parent, 2 where b is, 0 for a joint that closes a loop; of this, a counts as the parent.
  parent: i32;
  // Rows of the states of the parent and the child, 0 for one that does not move.
  parentRow: i32;
  childRow: i32;
  // The matrix of the hinge, and b/d and 1/d of its child.
  k00: f64;
  k01: f64;
  k11: f64;
  ratioX: f64;
  ratioY: f64;
  inverse: f64;
  // Anchors from the centres of the parent and the child, in the axes of the world, m.
  parentX: f64;
  parentY: f64;
  childX: f64;
  childY: f64;
  // Chord of the anchor of the child from that of the parent (chords.ts), m/s.
  chordX: f64;
  chordY: f64;
  // Intermediates of the solution, and the impulse on the child.
  valueX: f64;
  valueY: f64;
  turn: f64;
  impulseX: f64;
  impulseY: f64;
  // Largest impulse of a sub-step, squared.
  largest: f64;
}

export const PLAIN: i32 = 1;
export const WARM: i32 = 2;

const ROW: usize = offsetof<JointRow>();
const ROWS: usize = 5 * ROW;
const SIZE: usize = offsetof<JointWork>();

export const SPRING_ROW: i32 = 3;
export const MOTOR_ROW: i32 = 4;

// @ts-ignore: decorator
@inline export function workAt(t: JointTable, i: i32): JointWork {
  return changetype<JointWork>(t.works + <usize>i * SIZE);
}

// What the motor of a joint does with its tree: nothing (engage-motors.ts).
export const APART: i32 = 0;

// The rows that are locked at most.
export const MOST_LOCKS: i32 = 3;

// Whether a motor acts in another direction than limits and a spring do.
// @ts-ignore: decorator
@inline export function hasOwnDirection(work: JointWork): bool {
  const motor = rowOf(work, MOTOR_ROW);
  const limits = rowOf(work, SPRING_ROW);
  return motor.x != limits.x || motor.y != limits.y;
}

const PLACE: usize = offsetof<JointPlace>();

// @ts-ignore: decorator
@inline export function placeAt(t: JointTable, i: i32): JointPlace {
  return changetype<JointPlace>(t.places + <usize>i * PLACE);
}

const START: usize = offsetof<HingeStart>();

// @ts-ignore: decorator
@inline export function startAt(t: JointTable, i: i32): HingeStart {
  return changetype<HingeStart>(t.starts + <usize>i * START);
}

// @ts-ignore: decorator
@inline export function clearRows(t: JointTable, i: i32): void {
  workAt(t, i).rows = t.rows + <usize>i * ROWS;
  memory.fill(t.rows + <usize>i * ROWS, 0, ROWS);
}

// @ts-ignore: decorator
@inline export function rowOf(work: JointWork, i: i32): JointRow {
  return changetype<JointRow>(work.rows + <usize>i * ROW);
}

// What is done to the child is done to b, times this.
// @ts-ignore: decorator
@inline export function signOf(at: JointPlace): f64 {
  return at.parent == 2 ? -1 : 1;
}
