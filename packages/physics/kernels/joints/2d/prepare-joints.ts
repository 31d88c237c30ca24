// Begins and ends a step of the joints: which of them act, with which masses, from which impulses.
import { get } from '../../memory/columns';
import { ASLEEP, DYNAMIC, MOVES, SHIFTED, WAKES, flagsOf, poseOf, putFlags, putWord, word } from '../../solver/2d/body';
import { forgetBox, listAwake } from '../../solver/2d/gather-bodies';
import { wakeIsland } from '../../solver/2d/islands';
import { RigidTable } from '../../solver/2d/rigid-table';
import { keyAt, sortKeys } from '../../collision/broad-phase/2d/sort-keys';
import { JointImpulses, JointTable, impulsesOf } from './joint-table';
import { JOINT_WORK_SIZE, JointWork, MOTOR_ROW, SPRING_ROW, rowOf, workAt } from './joint-work';
import { applyAlong, stateA, stateB } from './joint-rows';
import { orderTrees } from './joint-trees';

// Lists the joints of which a body was removed, and the pairs that do not collide. Called before a step if joints or
// bodies were added or removed.
export function listJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  separatePairs(t, rigid);
  wakeReleased(t, rigid);
  t.orphanCount = 0;
  t.pairCount = 0;
  for (let i = 0; i < t.count; i++) {
    const id = word(t.ids, i);
    const a = word(t.a, id);
    const b = word(t.b, id);
    if (!hasGeneration(rigid, a, word(t.aGeneration, id)) || !hasGeneration(rigid, b, word(t.bGeneration, id))) {
      putWord(t.orphans, t.orphanCount++, id);
      continue;
    }
    if (word(t.collide, id) != 0) continue;
    const key = ((<u64>min<i32>(a, b)) << 32) | <u64>max<i32>(a, b);
    store<u64>(t.pairs + ((<usize>t.pairCount) << 3), key);
    t.pairCount++;
  }
  sortKeys(t.pairs, t.spare, t.pairCount);
  rigid.jointPairs = t.pairs;
  rigid.jointPairCount = t.pairCount;
}

// Bodies that sleep wake when a joint of theirs is gone.
function wakeReleased(t: JointTable, rigid: RigidTable): void {
  for (let i = 0; i < rigid.linkCount; i++) {
    const id = word(t.linkIds, i);
    const a = word(t.links, 2 * i);
    const b = word(t.links, 2 * i + 1);
    const isThere = (<u32>word(rigid.members, id) & t.jointBit) != 0;
    if (isThere && word(t.a, id) == a && word(t.b, id) == b) continue;
    wakeLater(rigid, a);
    wakeLater(rigid, b);
  }
}

// @ts-ignore: decorator
@inline function wakeLater(rigid: RigidTable, row: i32): void {
  if ((flagsOf(rigid, row) & ASLEEP) != 0) putFlags(rigid, row, flagsOf(rigid, row) | WAKES);
}

// Bodies that a joint kept from colliding look for each other again.
function separatePairs(t: JointTable, rigid: RigidTable): void {
  for (let i = 0; i < t.pairCount; i++) {
    const key = keyAt(t.pairs, i);
    forgetBox(rigid, <i32>(key >> 32));
    forgetBox(rigid, <i32>key);
  }
}

// @ts-ignore: decorator
@inline function hasGeneration(rigid: RigidTable, row: i32, generation: i32): bool {
  return row > 0 && word(rigid.generations, row) == generation && (word(rigid.members, row) & 1) != 0;
}

export function prepareJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  rigid.links = t.links;
  wakeJoined(t, rigid);
  t.activeCount = 0;
  for (let i = 0; i < t.count; i++) {
    const id = word(t.ids, i);
    if (word(t.started, id) == 0) {
      memory.fill(changetype<usize>(impulsesOf(t, id)), 0, 64);
      putWord(t.started, id, 1);
    }
    const a = word(t.a, id);
    const b = word(t.b, id);
    const movesA = isMoved(rigid, a);
    const movesB = isMoved(rigid, b);
    if (!movesA && !movesB) continue;
    putWord(t.nodes, 2 * t.activeCount, movesA ? a : 0);
    putWord(t.nodes, 2 * t.activeCount + 1, movesB ? b : 0);
    putWord(t.active, t.activeCount++, id);
  }
  orderTrees(t);
  t.workCount = 0;
  t.axisCount = 0;
  for (let k = 0; k < t.orderCount; k++) startWork(t, rigid, word(t.order, k));
}

// A body that sleeps wakes with what it is joined to, as far as that moves.
function wakeJoined(t: JointTable, rigid: RigidTable): void {
  let any = false;
  let links = 0;
  for (let i = 0; i < t.count; i++) {
    const id = word(t.ids, i);
    const a = word(t.a, id);
    const b = word(t.b, id);
    putWord(t.linkIds, i, id);
    putWord(t.links, links++, a);
    putWord(t.links, links++, b);
    const flagsA = flagsOf(rigid, a);
    const flagsB = flagsOf(rigid, b);
    const sleeps = ((flagsA | flagsB) & ASLEEP) != 0;
    if (!sleeps || !(isActive(flagsA) || isActive(flagsB))) continue;
    wakeIsland(rigid, (flagsA & ASLEEP) != 0 ? a : b);
    any = true;
  }
  rigid.linkCount = t.count;
  if (any) listAwake(rigid);
}

// @ts-ignore: decorator
@inline function isActive(flags: u32): bool {
  return ((flags & MOVES) != 0 && (flags & ASLEEP) == 0) || (flags & SHIFTED) != 0;
}

// @ts-ignore: decorator
@inline function isMoved(rigid: RigidTable, row: i32): bool {
  return (flagsOf(rigid, row) & (DYNAMIC | ASLEEP)) == DYNAMIC;
}

function startWork(t: JointTable, rigid: RigidTable, i: i32): void {
  const id = word(t.active, i);
  const a = word(t.a, id);
  const b = word(t.b, id);
  const impulses = impulsesOf(t, id);
  dropUnused(t, id, impulses);
  if (get(t.hertz, id) > 0 || get(t.maxMotor, id) > 0 || word(t.hasLimits, id) != 0)
    putWord(t.axes, t.axisCount++, t.workCount);
  const work = workAt(t, t.workCount++);
  memory.fill(changetype<usize>(work), 0, JOINT_WORK_SIZE);
  work.id = id;
  work.parent = word(t.parents, i);
  // A joint between bodies that sleep keeps its force.
  impulses.force = 0;
  work.rowA = a;
  work.rowB = b;
  work.a = (flagsOf(rigid, a) & MOVES) != 0 ? a : 0;
  work.b = (flagsOf(rigid, b) & MOVES) != 0 ? b : 0;
  work.massA = <f64>poseOf(rigid, a).inverseMass;
  work.inertiaA = <f64>poseOf(rigid, a).inverseInertia;
  work.massB = <f64>poseOf(rigid, b).inverseMass;
  work.inertiaB = <f64>poseOf(rigid, b).inverseInertia;
}

// Applies the impulses of the last sub-step once more.
export function warmStartJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  for (let i = 0; i < t.workCount; i++) {
    const work = workAt(t, i);
    const a = stateA(rigid, work);
    const b = stateB(rigid, work);
    const impulses = impulsesOf(t, work.id);
    if (work.locks > 0) applyAlong(work, a, b, rowOf(work, 0), impulses.lock0);
    if (work.locks > 1) applyAlong(work, a, b, rowOf(work, 1), impulses.lock1);
    if (work.locks > 2) applyAlong(work, a, b, rowOf(work, 2), impulses.lock2);
  }
  for (let i = 0; i < t.axisCount; i++) {
    const work = workAt(t, word(t.axes, i));
    const a = stateA(rigid, work);
    const b = stateB(rigid, work);
    const impulses = impulsesOf(t, work.id);
    applyAlong(work, a, b, rowOf(work, SPRING_ROW), impulses.spring + impulses.lower - impulses.upper);
    applyAlong(work, a, b, rowOf(work, MOTOR_ROW), impulses.motor);
  }
}

// Clears the impulses of a spring, motor or limit that was switched off.
function dropUnused(t: JointTable, id: i32, impulses: JointImpulses): void {
  if (!(get(t.hertz, id) > 0)) impulses.spring = 0;
  if (!(get(t.maxMotor, id) > 0)) impulses.motor = 0;
  if (word(t.hasLimits, id) == 0) {
    impulses.lower = 0;
    impulses.upper = 0;
  }
}

// Notes the largest force of the step, and lists the joints that it breaks.
export function watchJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  for (let i = 0; i < t.workCount; i++) {
    const work = workAt(t, i);
    const impulses = impulsesOf(t, work.id);
    const force = linearImpulse(work, impulses) / rigid.h;
    impulses.force = max<f64>(impulses.force, force);
  }
}

// The length of the sum of all impulses that are no torques, N s.
function linearImpulse(work: JointWork, impulses: JointImpulses): f64 {
  let x: f64 = 0;
  let y: f64 = 0;
  for (let p = 0; p < work.locks; p++) {
    const impulse = load<f64>(changetype<usize>(impulses) + ((<usize>p) << 3));
    x += impulse * rowOf(work, p).x;
    y += impulse * rowOf(work, p).y;
  }
  const free = impulses.spring + impulses.lower - impulses.upper;
  x += free * rowOf(work, SPRING_ROW).x + impulses.motor * rowOf(work, MOTOR_ROW).x;
  y += free * rowOf(work, SPRING_ROW).y + impulses.motor * rowOf(work, MOTOR_ROW).y;
  return sqrt<f64>(x * x + y * y);
}

export function listBroken(table: usize): void {
  const t = changetype<JointTable>(table);
  t.brokenCount = 0;
  for (let i = 0; i < t.workCount; i++) {
    const id = workAt(t, i).id;
    const limit = <f64>get(t.breakForce, id);
    if (limit > 0 && impulsesOf(t, id).force > limit) putWord(t.broken, t.brokenCount++, id);
  }
}
