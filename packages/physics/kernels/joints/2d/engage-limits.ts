// Limits of joints in trees. One that bears is a locked direction, solved together with all others of its tree. By itself it
// would know the masses of its two bodies and not what hangs on them: it would answer too weakly and too late, and so drive
// what it should stop.
//
//   foresee   what would be passed within the sub-step at the speeds with which the last one ended
//   predict   what would be passed with the impulses of the last one
//   engage    what would be passed with them, and at those speeds or without the impulses of joints, and what bears already
//   release   what would have to pull
//
// Source of the method, an active set: Nocedal and Wright, Numerical Optimization, section 16.5; here of one exchange in each
// sub-step, which begins with the set of the one before.
import { get } from '../../memory/columns';
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import {
  GEAR,
  JointImpulses,
  JointTable,
  PULLEY,
  impulsesOf,
  isCoupling,
  isSolvedApart,
  lockAddress,
} from './joint-table';
import { LOOP } from './joint-trees';
import { jointsOfTree, treeOfRow } from './list-by-tree';
import { JointRow, JointWork, SPRING_ROW, rowOf, workAt } from './joint-work';
import { addLock, applyAlong, bounded, removeLock, speedAlong, stateA, stateB } from './joint-rows';
import { exertCoupling, speedOfCoupling } from './solve-couplings';

// Which limit of a joint bears: that below, that above, or both, where they leave no room between them.
export const LOWER: i32 = 1;
export const UPPER: i32 = -1;
export const BOTH: i32 = 2;

// Before it is decided: which limits the speeds pass, and from which they lead back.
const PASSES_LOWER: i32 = 1;
const PASSES_UPPER: i32 = 2;
const LEAVES_LOWER: i32 = 4;
const LEAVES_UPPER: i32 = 8;
const PASSES_ANY: i32 = PASSES_LOWER | PASSES_UPPER;
// What is passed at the speeds with which the last sub-step ended: the same, times this.
const FORESEEN: i32 = 16;

// What comes back to a limit faster than this, m/s or rad/s, is not held there: only the overlap is corrected.
const LEAVES: f64 = 0.05;

// What bears goes on to do so this near to its limit, m or rad, as long as it needs to push: what rests on it does not tremble.
const SLOP: f64 = 0.05;
// It comes back to it at this many times the rate at which gaps close, within a few sub-steps. Contacts that are solved in turn
// with joints move it away: where others press a limb against its limit, and where they keep another limit of the tree passed. Beyond
// the slop it would be free for a sub-step, with all that presses on it, and fall on its limit: heaps of ragdolls would never rest.
const RETURN: f64 = 2.5;
// Limits closer to each other leave no room, m or rad.
const NO_ROOM: f64 = 1e-9;

// Whether the limits of a joint are solved with its tree. That of a pulley is its rope, which may be slack; a gear and a motor joint have
// no free coordinate that could be limited.
// @ts-ignore: decorator
@inline export function hasTreeLimits(t: JointTable, work: JointWork): bool {
  if (work.hasAxes == 0 || work.parent == LOOP) return false;
  return work.kind == PULLEY || (word(t.hasLimits, work.id) != 0 && !isSolvedApart(work.kind));
}

// @ts-ignore: decorator
@inline export function lowerOf(t: JointTable, work: JointWork): f64 {
  return work.kind == PULLEY ? 0 : <f64>get(t.lower, work.id);
}

// @ts-ignore: decorator
@inline export function upperOf(t: JointTable, work: JointWork): f64 {
  return work.kind == PULLEY ? Infinity : <f64>get(t.upper, work.id);
}

// Whether its limits hold a joint at one place.
// @ts-ignore: decorator
@inline export function leavesNoRoom(t: JointTable, work: JointWork): bool {
  return upperOf(t, work) - lowerOf(t, work) < NO_ROOM;
}

// @ts-ignore: decorator
@inline function speedOf(rigid: RigidTable, work: JointWork): f64 {
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  return work.kind == PULLEY ? speedOfCoupling(work, a, b) : speedAlong(a, b, rowOf(work, SPRING_ROW));
}

// Applies an impulse along the direction that is limited.
function exert(rigid: RigidTable, work: JointWork, impulse: f64): void {
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  if (isCoupling(work.kind)) exertCoupling(work, a, b, impulse);
  else applyAlong(work, a, b, rowOf(work, SPRING_ROW), impulse);
}

// Notes which limits of a joint would be passed at the speeds with which the last sub-step ended, before anything is done to the bodies but
// by forces.
export function foreseeLimits(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  if (hasTreeLimits(t, work)) work.limit = FORESEEN * (passedLimits(t, rigid, work) & PASSES_ANY);
}

// Notes which would be passed at the speeds with the impulses of the last sub-step. Those know the load of a joint, but an impact seems
// to continue in them; the speeds without them know that it is over, but nothing bears a load in them: what contacts exert against
// joints then has nothing against it, and a limit beside such a joint seems to be left. A limit is passed where the speeds with the
// impulses say so, and the speeds without them or those with which the last sub-step ended.
export function predictLimits(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  if (hasTreeLimits(t, work)) work.limit |= passedLimits(t, rigid, work);
}

// Which limits of a joint its present speed passes within the sub-step, and from which it leads back.
function passedLimits(t: JointTable, rigid: RigidTable, work: JointWork): i32 {
  const row = rowOf(work, SPRING_ROW);
  const speed = row.chord + speedOf(rigid, work);
  const then = row.error + rigid.h * speed;
  const passes = (then < lowerOf(t, work) ? PASSES_LOWER : 0) | (then > upperOf(t, work) ? PASSES_UPPER : 0);
  return passes | (speed > LEAVES ? LEAVES_LOWER : 0) | (speed < -LEAVES ? LEAVES_UPPER : 0);
}

// Decides which limit of a joint bears, and makes it one of its locked directions.
export function engageLimit(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  if (!hasTreeLimits(t, work)) return;
  const passes = work.limit & (passedLimits(t, rigid, work) | (work.limit / FORESEEN));
  work.limit = 0;
  const row = rowOf(work, SPRING_ROW);
  const low = row.error - lowerOf(t, work);
  const high = upperOf(t, work) - row.error;
  const impulses = impulsesOf(t, work.id);
  const passesLower = (passes & PASSES_LOWER) != 0;
  const passesUpper = (passes & PASSES_UPPER) != 0;
  const lower = passesLower || (pushFromBelow(impulses, work) > 0 && low < SLOP);
  const upper = passesUpper || (work.kind != PULLEY && impulses.upper > 0 && high < SLOP);
  impulses.lower = 0;
  impulses.upper = 0;
  work.returns = 0;
  if (low + high < NO_ROOM) {
    lock(work, row, BOTH, bounded(low));
  } else if (lower && (!upper || low < high)) {
    work.returns = isAlone(t, work) ? passes & LEAVES_LOWER : 0;
    lock(work, row, LOWER, errorOf(low, passesLower, rigid.h));
  } else if (upper) {
    work.returns = isAlone(t, work) ? passes & LEAVES_UPPER : 0;
    lock(work, row, UPPER, -errorOf(high, passesUpper, rigid.h));
  }
}

// Whether a joint is all that its tree has. Among others its speed does not tell whether it would come back without being held.
function isAlone(t: JointTable, work: JointWork): bool {
  const tree = treeOfRow(t, work.a != 0 ? work.a : work.b);
  return tree >= 0 && jointsOfTree(t, tree) == 1;
}

// The error for which a limit is reached within the sub-step, where that lies before it.
// @ts-ignore: decorator
@inline function errorOf(gap: f64, passes: bool, h: f64): f64 {
  if (gap < 0) return bounded(gap);
  return passes ? gap / (h * softness.biasRate) : RETURN * gap;
}

function lock(work: JointWork, from: JointRow, side: i32, error: f64): void {
  work.limit = side;
  if (work.kind == PULLEY) {
    from.error = error;
    return;
  }
  work.limitLock = addLock(work, from, error, from.chord);
  if (work.limitLock < 0) work.limit = 0;
}

// Takes back what a gear and the limits of a joint exerted in the last sub-step, as what locked directions did.
export function takeBackLimits(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  const impulses = impulsesOf(t, work.id);
  if (work.kind == GEAR && work.parent != LOOP) exert(rigid, work, -impulses.lock0);
  if (!hasTreeLimits(t, work)) return;
  exert(rigid, work, work.kind == PULLEY ? -impulses.upper : impulses.upper - impulses.lower);
}

// Lets the limits of all joints go that would have to pull, or to stop what comes back. Returns whether there are any.
export function releaseLimits(t: JointTable, rigid: RigidTable): bool {
  let any = false;
  for (let k = 0; k < t.closedCount; k++) {
    const work = workAt(t, k);
    if (work.limit == 0 || work.limit == BOTH) continue;
    const impulse = lastLock(impulsesOf(t, work.id), work);
    if (impulse * work.limit >= 0 && work.returns == 0) continue;
    exert(rigid, work, -impulse);
    unlock(t, work);
    any = true;
  }
  return any;
}

// Ends a sub-step: what the limit that bore has exerted.
export function settleLimit(t: JointTable, work: JointWork): void {
  const side = work.limit;
  if (side == 0) return;
  work.bore = side;
  const impulses = impulsesOf(t, work.id);
  const impulse = lastLock(impulses, work);
  unlock(t, work);
  if (work.kind == PULLEY) {
    impulses.upper = max<f64>(0, impulse);
  } else {
    // It may have to pull in the last pass, as what rests on it is lifted: that is less than nothing, and no push of the other.
    impulses.lower = side == LOWER || (side == BOTH && impulse > 0) ? impulse : 0;
    impulses.upper = side == UPPER || (side == BOTH && impulse < 0) ? -impulse : 0;
  }
}

function unlock(t: JointTable, work: JointWork): void {
  work.limit = 0;
  const impulses = impulsesOf(t, work.id);
  if (work.kind == PULLEY) impulses.upper = 0;
  else removeLock(work, impulses, work.limitLock);
}

// What pushed in the last sub-step from the lower limit; a rope does so by its tension.
// @ts-ignore: decorator
@inline function pushFromBelow(impulses: JointImpulses, work: JointWork): f64 {
  return work.kind == PULLEY ? impulses.upper : impulses.lower;
}

// @ts-ignore: decorator
@inline function lastLock(impulses: JointImpulses, work: JointWork): f64 {
  return work.kind == PULLEY ? impulses.upper : load<f64>(lockAddress(impulses, work.limitLock));
}
