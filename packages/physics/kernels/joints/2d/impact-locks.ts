// Limits and motors in an impact. A suspension that bottoms out, a leg that is stretched, or one whose motor holds it, passes the impact on to
// what it stands on. So limits that an impact passes, and motors that stand still and can hold that, are locked directions of their
// trees until it is over. That takes energy and gives none. What bounces does so against the limits that bore in the step: these
// are locked, too, as long as they need to push.
import { get } from '../../memory/columns';
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { BOTH, LOWER, UPPER, hasTreeLimits, leavesNoRoom, lowerOf, upperOf } from './engage-limits';
import { JointTable, PULLEY, impulsesOf, isSolvedApart } from './joint-table';
import { addLock, coupling, removeLock, speedAlong, stateA, stateB } from './joint-rows';
import {
  JointRow,
  JointWork,
  MOST_LOCKS,
  MOTOR_ROW,
  SPRING_ROW,
  hasOwnDirection,
  placeAt,
  rowOf,
  signOf,
  workAt,
} from './joint-work';
import { jointsOfTree } from './list-by-tree';

// A motor or a spring may have driven a joint from its limit if that leaves it faster than this, m/s.
const LEAVES: f64 = 0.5;

// A limit pulls where it keeps its bodies from parting faster than this, m/s: less is what rounding leaves.
const LEAST_PULL: f64 = 0.01;

// Locks what the joints of a tree pass within the step, faster than `slowest`, m/s. Returns whether there is anything.
export function lockStruck(t: JointTable, rigid: RigidTable, tree: i32, slowest: f64): bool {
  let any = false;
  const first = word(t.treeStarts, tree);
  for (let i = 0; i < jointsOfTree(t, tree); i++) {
    const work = workAt(t, word(t.treeJoints, first + i));
    if (isFree(t, work) && strikesLimit(t, rigid, work, slowest)) any = true;
    if (isFree(t, work) && strikesMotor(t, rigid, work, slowest)) any = true;
  }
  return any;
}

// @ts-ignore: decorator
@inline function isFree(t: JointTable, work: JointWork): bool {
  return work.hasAxes != 0 && work.locks < MOST_LOCKS && !isSolvedApart(work.kind);
}

function strikesLimit(t: JointTable, rigid: RigidTable, work: JointWork, slowest: f64): bool {
  return work.limit == 0 && lockLimit(work, passedLimit(t, rigid, work, rigid.dt, slowest));
}

// Locks a limit, if it is one, 0 for none.
function lockLimit(work: JointWork, limit: i32): bool {
  work.limit = limit;
  if (limit == 0) return false;
  const row = rowOf(work, SPRING_ROW);
  // At rest, even if it had some way to go: a direction that is to move would be driven against whatever the impact presses on it.
  work.limitLock = addLock(work, row, 0, row.chord);
  return true;
}

// A brake holds what two free bodies do, if it can. A motor that runs would drive all that it pushes from one body to the next.
function strikesMotor(t: JointTable, rigid: RigidTable, work: JointWork, slowest: f64): bool {
  const most = <f64>get(t.maxMotor, work.id) * rigid.dt;
  if (
    !(most > 0) ||
    get(t.motorSpeed, work.id) != 0 ||
    work.motorLock >= 0 ||
    (work.limit != 0 && !hasOwnDirection(work))
  )
    return false;
  const row = rowOf(work, MOTOR_ROW);
  const speed = abs<f64>(speedAlong(stateA(rigid, work), stateB(rigid, work), row));
  if (!(lengthOf(work, row) * speed > slowest) || speed > most * coupling(work, row, row)) return false;
  work.motorLock = addLock(work, row, 0, 0);
  return true;
}

// Whether a joint may pass a limit within a step, faster than `slowest`. Its row may be of the last sub-step.
export function mayStrike(t: JointTable, rigid: RigidTable, k: i32, slowest: f64): bool {
  return passedLimit(t, rigid, workAt(t, k), rigid.dt + rigid.h, slowest) != 0;
}

// Which limit of a joint is passed in so many seconds, 0 for none. A rope over pulleys is left to the sub-steps.
function passedLimit(t: JointTable, rigid: RigidTable, work: JointWork, seconds: f64, slowest: f64): i32 {
  if (work.kind == PULLEY || !hasTreeLimits(t, work)) return 0;
  const row = rowOf(work, SPRING_ROW);
  const length = lengthOf(work, row);
  const speed = speedAlong(stateA(rigid, work), stateB(rigid, work), row);
  if (-length * (speed + roomOf(t, work, LOWER) / seconds) > slowest) return LOWER;
  return length * (speed - roomOf(t, work, UPPER) / seconds) > slowest ? UPPER : 0;
}

// How far a joint is from its limit, m or rad; 0 beyond it.
function roomOf(t: JointTable, work: JointWork, side: i32): f64 {
  const at = rowOf(work, SPRING_ROW).error;
  return max<f64>(0, side == LOWER ? at - lowerOf(t, work) : upperOf(t, work) - at);
}

// What turns the speed of a joint into m/s: 1, or for one that turns the distance at which the mass of its bodies has their inertia, m.
function lengthOf(work: JointWork, row: JointRow): f64 {
  if (row.x != 0 || row.y != 0) return 1;
  const inertia = work.inertiaA + work.inertiaB;
  return inertia > 0 ? sqrt<f64>((work.massAx + work.massAy + work.massBx + work.massBy) / (2 * inertia)) : 0;
}

// Locks the limits of a tree that bore in the step, before the impulses of an impact are taken back: what they exerted against these goes
// with them. Returns whether there are any.
export function lockBearing(t: JointTable, rigid: RigidTable, tree: i32): bool {
  let any = false;
  const first = word(t.treeStarts, tree);
  for (let i = 0; t.otherCount > 0 && i < jointsOfTree(t, tree); i++) {
    const work = workAt(t, word(t.treeJoints, first + i));
    if (work.limit != 0 || !isFree(t, work) || !hasTreeLimits(t, work)) continue;
    if (lockLimit(work, bearingLimit(t, rigid, work))) any = true;
  }
  return any;
}

function bearingLimit(t: JointTable, rigid: RigidTable, work: JointWork): i32 {
  if (leavesNoRoom(t, work)) return BOTH;
  const impulses = impulsesOf(t, work.id);
  if (impulses.lower > 0) return LOWER;
  if (impulses.upper > 0) return UPPER;
  if (!(get(t.maxMotor, work.id) > 0) && !(get(t.hertz, work.id) > 0)) return work.bore;
  const row = rowOf(work, SPRING_ROW);
  const speed = lengthOf(work, row) * (speedAlong(stateA(rigid, work), stateB(rigid, work), row) + row.chord);
  return work.bore * speed < LEAVES ? work.bore : 0;
}

// Lets the limits of a tree go that had to pull in an impact, after the projection that took the impulses of it back. Returns whether
// there are any.
export function releasePulling(t: JointTable, tree: i32): bool {
  let any = false;
  const first = word(t.treeStarts, tree);
  for (let i = 0; i < jointsOfTree(t, tree); i++) {
    const k = word(t.treeJoints, first + i);
    const work = workAt(t, k);
    if (work.limit == 0 || work.limit == BOTH) continue;
    const row = rowOf(work, work.limitLock);
    const push = signOf(placeAt(t, k)) * row.value * work.limit;
    if (!(-push * coupling(work, row, row) * lengthOf(work, row) > LEAST_PULL)) continue;
    const impulses = impulsesOf(t, work.id);
    removeLock(work, impulses, work.limitLock);
    impulses.lower = 0;
    impulses.upper = 0;
    work.limit = 0;
    any = true;
  }
  return any;
}

// Ends an impact. Returns whether anything was locked: the matrices are to be made again.
export function unlockStruck(t: JointTable): bool {
  let any = false;
  for (let k = 0; k < t.treeCount; k++) {
    const work = workAt(t, k);
    if (work.limit != 0) removeLock(work, impulsesOf(t, work.id), work.limitLock);
    if (work.motorLock >= 0) removeLock(work, impulsesOf(t, work.id), work.motorLock);
    if (work.limit != 0 || work.motorLock >= 0) any = true;
    work.limit = 0;
    work.motorLock = -1;
  }
  return any;
}
