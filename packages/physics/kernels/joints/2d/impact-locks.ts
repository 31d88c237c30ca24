// Limits and motors in an impact. A suspension that bottoms out, a leg that is stretched, or one whose motor holds it, passes the impact on to
// what it stands on. So limits that an impact passes, and motors that stand still and can hold that, are locked directions of their
// trees until it is over. That takes energy and gives none.
import { get } from '../../memory/columns';
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { LOWER, UPPER, hasTreeLimits, lowerOf, upperOf } from './engage-limits';
import { JointTable, PULLEY, impulsesOf, isSolvedApart } from './joint-table';
import { addLock, coupling, removeLock, speedAlong, stateA, stateB } from './joint-rows';
import { JointRow, JointWork, MOST_LOCKS, MOTOR_ROW, SPRING_ROW, hasOwnDirection, rowOf, workAt } from './joint-work';
import { jointsOfTree } from './list-by-tree';

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
  if (work.limit != 0) return false;
  work.limit = passedLimit(t, rigid, work, rigid.dt, slowest);
  if (work.limit == 0) return false;
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
