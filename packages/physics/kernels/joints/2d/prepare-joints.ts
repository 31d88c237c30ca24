// Begins a step of the joints: which of them act, with which masses, from where.
import { get } from '../../memory/columns';
import { DRIVEN, flagsOf, poseOf, putFlags, stateOf, word } from '../../solver/2d/body';
import { inverseMassX, inverseMassY } from '../../solver/2d/motion-locks';
import { RigidTable } from '../../solver/2d/rigid-table';
import { sleeperOf } from '../../solver/2d/sleeper';
import { articulated } from './articulated-body';
import { braceBodies, jointed, keepVelocity, startJointed, stiffen } from './brace-joints';
import { beginLoops, braceLoops, markLoops } from './color-loops';
import { DISTANCE, JointTable, impulsesOf, isSolvedApart } from './joint-table';
import { CLOSING, PARENT_B } from './joint-trees';
import { speedAlong, stateA, stateB } from './joint-rows';
import { JointWork, MOTOR_ROW, PLAIN, placeAt, rowOf, startAt, workAt } from './joint-work';
import { layOutJoints } from './lay-out-joints';
import { listActive } from './list-active';
import { measureJoint } from './measure-joints';
import { RAIL_MASS } from './start-joints';
import { wakeJoined } from './wake-joints';
import { stiffenByLocks } from './watch-joints';

export function prepareJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  rigid.links = t.links;
  wakeJoined(t, rigid);
  if (listActive(t, rigid)) layOutJoints(t, rigid);
  markLoops(t, rigid);
  for (let i = 0; i < t.bodyCount; i++) {
    const row = word(t.bodyRows, i);
    startJointed(t, rigid, row);
    const body = articulated(t, i);
    const state = stateOf(rigid, row);
    body.vx = <f64>state.vx;
    body.vy = <f64>state.vy;
    body.w = <f64>state.w;
  }
  for (let k = t.treeCount; k < t.workCount; k++) {
    startJointed(t, rigid, workAt(t, k).a);
    startJointed(t, rigid, workAt(t, k).b);
  }
  for (let k = 0; k < t.workCount; k++) {
    if (placeAt(t, k).hinge != PLAIN) beginRows(t, rigid, k);
    if (placeAt(t, k).hinge != 0) beginHinge(t, rigid, k);
  }
  beginLoops(t, rigid);
  const braced = braceBodies(t, rigid);
  braceLoops(t);
  for (let k = 0; braced && k < t.workCount; k++) if (placeAt(t, k).hinge != 0) braceHinge(t, k);
  for (let k = 0; t.otherCount > 0 && k < t.workCount; k++) if (placeAt(t, k).hinge != PLAIN) braceRows(t, k);
}

// Begins a step of a joint that has rows.
function beginRows(t: JointTable, rigid: RigidTable, k: i32): void {
  const work = workAt(t, k);
  const id = work.id;
  work.bore = 0;
  work.localAx = <f64>get(t.ax, id);
  work.localAy = <f64>get(t.ay, id);
  work.localBx = <f64>get(t.bx, id);
  work.localBy = <f64>get(t.by, id);
  work.massAx = <f64>inverseMassX(rigid, work.rowA);
  work.massAy = <f64>inverseMassY(rigid, work.rowA);
  work.massBx = <f64>inverseMassX(rigid, work.rowB);
  work.massBy = <f64>inverseMassY(rigid, work.rowB);
  // A direction across which nothing can move would take an impulse without bound, and its rounding throw a body along its free axis.
  const ofA = <f64>poseOf(rigid, work.rowA).inverseMass;
  const ofB = <f64>poseOf(rigid, work.rowB).inverseMass;
  work.railX = (ofA - work.massAx + (ofB - work.massBx)) / RAIL_MASS;
  work.railY = (ofA - work.massAy + (ofB - work.massBy)) / RAIL_MASS;
  work.largestTurn = 0;
  keepVelocity(t, rigid, work.a);
  keepVelocity(t, rigid, work.b);
  const at = placeAt(t, k);
  at.largest = 0;
  at.turns = poseOf(rigid, at.childRow).inverseInertia > 0 ? 1 : 0;
  if (isDriving(t, work)) {
    if (work.a != 0) putFlags(rigid, work.a, flagsOf(rigid, work.a) | DRIVEN);
    if (work.b != 0) putFlags(rigid, work.b, flagsOf(rigid, work.b) | DRIVEN);
  }
  if (at.hinge != 0) return;
  measureJoint(t, k);
  if (isRunning(t, rigid, work)) {
    if (work.a != 0) sleeperOf(rigid, work.a).stillFor = 0;
    if (work.b != 0) sleeperOf(rigid, work.b).stillFor = 0;
  }
  if (work.locks > 0 || work.kind == DISTANCE) stiffenByLocks(t, work, impulsesOf(t, id));
}

// Whether a joint may give energy. In a mechanism pulleys and gears give none; a motor that stands still only rubs.
function isDriving(t: JointTable, work: JointWork): bool {
  if (isSolvedApart(work.kind)) return work.parent != CLOSING;
  if (work.hasAxes == 0) return false;
  return get(t.hertz, work.id) > 0 || (get(t.maxMotor, work.id) > 0 && get(t.motorSpeed, work.id) != 0);
}

// Whether a motor turns or moves its joint at half its speed at least: what it moves does not sleep, however slow it is.
function isRunning(t: JointTable, rigid: RigidTable, work: JointWork): bool {
  if (work.hasAxes == 0 || isSolvedApart(work.kind) || !(get(t.maxMotor, work.id) > 0)) return false;
  const wanted = <f64>get(t.motorSpeed, work.id);
  const speed = speedAlong(stateA(rigid, work), stateB(rigid, work), rowOf(work, MOTOR_ROW));
  return wanted != 0 && speed / wanted > 0.5;
}

// The inertias that rows see.
function braceRows(t: JointTable, k: i32): void {
  const work = workAt(t, k);
  work.inertiaA = jointed(t, work.a).inverseInertia;
  work.inertiaB = jointed(t, work.b).inverseInertia;
}

// @ts-ignore: decorator
@inline function braceHinge(t: JointTable, k: i32): void {
  const at = placeAt(t, k);
  const start = startAt(t, k);
  start.halfStepParent = jointed(t, at.parentRow).halfStep;
  start.halfStepChild = jointed(t, at.childRow).halfStep;
}

// @ts-ignore: decorator
@inline function beginHinge(t: JointTable, rigid: RigidTable, k: i32): void {
  const at = placeAt(t, k);
  const start = startAt(t, k);
  const work = workAt(t, k);
  const id = at.id;
  const swaps = at.parent == PARENT_B;
  const parent = poseOf(rigid, swaps ? work.rowB : work.rowA);
  const child = poseOf(rigid, swaps ? work.rowA : work.rowB);
  const px = <f64>get(swaps ? t.bx : t.ax, id);
  const py = <f64>get(swaps ? t.by : t.ay, id);
  const cx = <f64>get(swaps ? t.ax : t.bx, id);
  const cy = <f64>get(swaps ? t.ay : t.by, id);
  start.parentX = <f64>parent.c * px - <f64>parent.s * py;
  start.parentY = <f64>parent.s * px + <f64>parent.c * py;
  start.childX = <f64>child.c * cx - <f64>child.s * cy;
  start.childY = <f64>child.s * cx + <f64>child.c * cy;
  start.x = <f64>child.x - <f64>parent.x;
  start.y = <f64>child.y - <f64>parent.y;
  start.halfStepParent = 0.5 * rigid.h;
  start.halfStepChild = 0.5 * rigid.h;
  at.largest = 0;
  at.turns = child.inverseInertia > 0 ? 1 : 0;
  stiffen(t, at.childRow, at.impulseX, at.impulseY, start.childX, start.childY);
  stiffen(t, at.parentRow, at.impulseX, at.impulseY, -start.parentX, -start.parentY);
}
