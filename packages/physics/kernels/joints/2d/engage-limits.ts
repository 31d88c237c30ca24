// Limits of joints in trees. One that bears is a locked direction, solved together with all others of its tree. By itself it
// would know the masses of its two bodies and not what hangs on them: it would answer too weakly and too late, and so drive
// what it should stop.
//
//   predict   what would be passed within the sub-step, with the impulses of the last one
//   engage    what would be passed without them too, and what bears already
//   release   what would have to pull
//
// Source of the method, an active set: Nocedal and Wright, Numerical Optimization, section 16.5; here of one exchange in each
// sub-step, which begins with the set of the one before.
import { get } from '../../memory/columns';
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { JointImpulses, JointTable, impulsesOf, lockAddress } from './joint-table';
import { LOOP } from './joint-trees';
import { JointRow, JointWork, SPRING_ROW, rowOf, workAt } from './joint-work';
import { applyAlong, speedAlong, stateA, stateB } from './joint-rows';

// Which limit of a joint bears: that below, that above, or both, where they leave no room between them.
const LOWER: i32 = 1;
const UPPER: i32 = -1;
const BOTH: i32 = 2;

// Before it is decided: which limits the speeds pass.
const PASSES_LOWER: i32 = 1;
const PASSES_UPPER: i32 = 2;

// What bears goes on to do so this near to its limit, m or rad, as long as it needs to push: what rests on it does not tremble.
const SLOP: f64 = 0.005;
// Limits closer to each other leave no room, m or rad.
const NO_ROOM: f64 = 1e-9;

// Whether the limits of a joint are solved with its tree.
// @ts-ignore: decorator
@inline function hasTreeLimits(t: JointTable, work: JointWork): bool {
  return work.hasAxes != 0 && work.parent != LOOP && word(t.hasLimits, work.id) != 0;
}

// Notes which limits of a joint would be passed at the speeds with the impulses of the last sub-step. Those know the load of a
// joint, but an impact seems to continue in them; the speeds without them know that it is over, but nothing bears a load in them.
// A limit is passed where both say so.
export function predictLimits(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  if (hasTreeLimits(t, work)) work.limit = passedLimits(t, rigid, work);
}

// Which limits of a joint its present speed passes within the sub-step.
function passedLimits(t: JointTable, rigid: RigidTable, work: JointWork): i32 {
  const row = rowOf(work, SPRING_ROW);
  const then = row.error + rigid.h * (row.chord + speedAlong(stateA(rigid, work), stateB(rigid, work), row));
  return (
    (then < <f64>get(t.lower, work.id) ? PASSES_LOWER : 0) | (then > <f64>get(t.upper, work.id) ? PASSES_UPPER : 0)
  );
}

// Decides which limit of a joint bears, and makes it the last of its locked directions.
export function engageLimit(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  if (!hasTreeLimits(t, work)) return;
  const passes = work.limit & passedLimits(t, rigid, work);
  work.limit = 0;
  const row = rowOf(work, SPRING_ROW);
  const low = row.error - <f64>get(t.lower, work.id);
  const high = <f64>get(t.upper, work.id) - row.error;
  const impulses = impulsesOf(t, work.id);
  const passesLower = (passes & PASSES_LOWER) != 0;
  const passesUpper = (passes & PASSES_UPPER) != 0;
  const lower = passesLower || (impulses.lower > 0 && low < SLOP);
  const upper = passesUpper || (impulses.upper > 0 && high < SLOP);
  impulses.lower = 0;
  impulses.upper = 0;
  if (low + high < NO_ROOM) {
    lock(work, row, BOTH, low);
  } else if (lower && (!upper || low < high)) {
    lock(work, row, LOWER, errorOf(low, passesLower, rigid.h));
  } else if (upper) {
    lock(work, row, UPPER, -errorOf(high, passesUpper, rigid.h));
  }
}

// The error for which a limit is reached within the sub-step, where that lies before it.
// @ts-ignore: decorator
@inline function errorOf(gap: f64, passes: bool, h: f64): f64 {
  if (gap < 0) return gap;
  return passes ? gap / (h * softness.biasRate) : 0;
}

function lock(work: JointWork, from: JointRow, side: i32, error: f64): void {
  const to = rowOf(work, work.locks++);
  to.x = from.x;
  to.y = from.y;
  to.armA = from.armA;
  to.armB = from.armB;
  to.error = error;
  to.chord = from.chord;
  work.limit = side;
}

// Takes back what the limits of a joint exerted in the last sub-step, as what its locked directions did.
export function takeBackLimits(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  if (!hasTreeLimits(t, work)) return;
  const impulses = impulsesOf(t, work.id);
  const row = rowOf(work, SPRING_ROW);
  applyAlong(work, stateA(rigid, work), stateB(rigid, work), row, impulses.upper - impulses.lower);
}

// Lets the limits of all joints go that would have to pull. Returns whether there are any.
export function releaseLimits(t: JointTable, rigid: RigidTable): bool {
  let any = false;
  for (let k = 0; k < t.closedCount; k++) {
    const work = workAt(t, k);
    if (work.limit == 0 || work.limit == BOTH) continue;
    const impulse = lastLock(impulsesOf(t, work.id), work);
    if (impulse * work.limit >= 0) continue;
    applyAlong(work, stateA(rigid, work), stateB(rigid, work), rowOf(work, SPRING_ROW), -impulse);
    unlock(t, work);
    any = true;
  }
  return any;
}

// Ends a sub-step: what the limit that bore has exerted.
export function settleLimit(t: JointTable, work: JointWork): void {
  if (work.limit == 0) return;
  const impulses = impulsesOf(t, work.id);
  const impulse = lastLock(impulses, work);
  impulses.lower = max<f64>(0, impulse);
  impulses.upper = max<f64>(0, -impulse);
  unlock(t, work);
}

function unlock(t: JointTable, work: JointWork): void {
  work.limit = 0;
  work.locks--;
  memory.fill(changetype<usize>(rowOf(work, work.locks)), 0, offsetof<JointRow>());
  store<f64>(lockAddress(impulsesOf(t, work.id), work.locks), 0);
}

// @ts-ignore: decorator
@inline function lastLock(impulses: JointImpulses, work: JointWork): f64 {
  return load<f64>(lockAddress(impulses, work.locks - 1));
}
