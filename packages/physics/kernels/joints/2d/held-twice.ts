// Several joints of the same two bodies, such as two hinges, or a weld and a rod: what the joint of the tree locks is not locked
// again. Both would agree only where no joint has an error; as soon as a blow turns one body a little against the other, they want
// to correct what neither can, press against each other with forces without bound, and turn the bodies by the tiny levers that are
// left. So of a joint that closes a loop with a joint of the same bodies those directions stay that are free, as far as they are
// independent: of two hinges the direction across the line between them, and of a joint beside a weld none.
import { ARTICULATED_BODY_SIZE } from './articulated-body';
import { JointTable } from './joint-table';
import { JointPlace, JointWork, placeAt, rowOf, workAt } from './joint-work';
import { LoopRow, clearDirection, loopRow } from './loop-row';

// A direction is locked already if no more than this part of it is new.
const NEW: f64 = 1e-3;

// What is locked of the motion of the second body against the first: at most three orthogonal directions x, y, and turn, each times
// the root of the inverse masses of both along it.
const LOCKED = memory.data(9 * 8, 8);
let lockedCount: i32 = 0;

// A direction in the same units, with what the locked ones have of it taken away.
let newX: f64 = 0;
let newY: f64 = 0;
let newTurn: f64 = 0;

// Bits of the directions of the joint that stay.
let kept: i32 = 0;

// Clears the directions from `first` to `end`, which are those of a joint, as far as other joints of its bodies lock them.
export function clearHeldTwice(t: JointTable, work: JointWork, first: i32, end: i32): void {
  if (first == end) return;
  const row = loopRow(t, first);
  if (row.a == 0 || row.b == 0) return;
  lockedCount = 0;
  let beside = jointAbove(t, row.a, row.b);
  if (beside < 0) beside = jointAbove(t, row.b, row.a);
  if (beside >= 0) lockJoint(t, work, beside);
  for (let i = 0; i < first; i++) lockRow(work, loopRow(t, i), row.a, row.b);
  if (lockedCount == 0) return;
  kept = 0;
  // That of which most is new comes first.
  for (let left = first; left < end; left++) {
    let best = -1;
    let most = NEW;
    for (let i = first; i < end; i++) {
      const part = isOpen(i, first) ? newPart(work, loopRow(t, i)) : 0;
      if (part > most) {
        most = part;
        best = i;
      }
    }
    if (best < 0) break;
    newPart(work, loopRow(t, best));
    keep();
    kept |= 1 << (best - first);
  }
  for (let i = first; i < end; i++) if (isOpen(i, first)) clearDirection(loopRow(t, i));
}

// @ts-ignore: decorator
@inline function isOpen(i: i32, first: i32): bool {
  return (kept & (1 << (i - first))) == 0;
}

// The joint of the tree by which a body hangs on another, -1 if it does not.
function jointAbove(t: JointTable, body: usize, above: usize): i32 {
  const k = <i32>((body - t.bodies) / ARTICULATED_BODY_SIZE) - t.rootCount;
  return k >= 0 && placeAt(t, k).above == above ? k : -1;
}

// Locks what a joint of the tree locks by itself: limits, motors and springs let go.
function lockJoint(t: JointTable, work: JointWork, k: i32): void {
  const at = placeAt(t, k);
  if (at.hinge != 0) return lockHinge(work, at);
  const other = workAt(t, k);
  for (let p = 0; p < other.ownLocks; p++) {
    const row = rowOf(other, p);
    lock(work, row.x, row.y, other.a == work.a ? row.armA : row.armB);
  }
}

function lockHinge(work: JointWork, at: JointPlace): void {
  const isChild = at.childRow == work.a;
  lock(work, 1, 0, isChild ? -at.childY : -at.parentY);
  lock(work, 0, 1, isChild ? at.childX : at.parentX);
}

// Locks a direction of an earlier joint of the same two bodies.
function lockRow(work: JointWork, row: LoopRow, a: usize, b: usize): void {
  if (row.a == a && row.b == b) lock(work, row.ax, row.ay, row.aw);
  if (row.a == b && row.b == a) lock(work, row.bx, row.by, row.bw);
}

function lock(work: JointWork, dx: f64, dy: f64, arm: f64): void {
  if (project(work, dx, dy, arm) > NEW) keep();
}

// How much of a direction is new.
function newPart(work: JointWork, row: LoopRow): f64 {
  return project(work, row.ax, row.ay, row.aw);
}

function project(work: JointWork, dx: f64, dy: f64, arm: f64): f64 {
  newX = dx * sqrt<f64>(work.massAx + work.massBx);
  newY = dy * sqrt<f64>(work.massAy + work.massBy);
  newTurn = arm * sqrt<f64>(work.inertiaA + work.inertiaB);
  const all = newX * newX + newY * newY + newTurn * newTurn;
  for (let i: usize = 0; i < <usize>lockedCount; i++) {
    const at = LOCKED + 24 * i;
    const part = newX * load<f64>(at) + newY * load<f64>(at, 8) + newTurn * load<f64>(at, 16);
    newX -= part * load<f64>(at);
    newY -= part * load<f64>(at, 8);
    newTurn -= part * load<f64>(at, 16);
  }
  return all > 0 ? sqrt<f64>((newX * newX + newY * newY + newTurn * newTurn) / all) : 0;
}

// Adds the direction that was projected last to the locked ones.
function keep(): void {
  if (lockedCount == 3) return;
  const scale = 1 / sqrt<f64>(newX * newX + newY * newY + newTurn * newTurn);
  const at = LOCKED + 24 * <usize>lockedCount;
  lockedCount++;
  store<f64>(at, scale * newX);
  store<f64>(at, scale * newY, 8);
  store<f64>(at, scale * newTurn, 16);
}
