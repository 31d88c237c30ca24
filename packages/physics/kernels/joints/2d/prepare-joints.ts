// Begins a step of the joints: which of them act, with which masses, from which impulses.
import { get } from '../../memory/columns';
import { ASLEEP, DYNAMIC, MOVES, flagsOf, poseOf, putWord, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { FILTER, IMPULSES_SIZE, JointImpulses, JointTable, MOTOR, impulsesOf } from './joint-table';
import { clearRows, clearWork, isHinge } from './joint-work';
import { clearTrees, orderTrees } from './joint-trees';
import { wakeJoined } from './wake-joints';

export function prepareJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  rigid.links = t.links;
  wakeJoined(t, rigid);
  t.activeCount = 0;
  for (let i = 0; i < t.count; i++) {
    const id = word(t.ids, i);
    if (word(t.started, id) == 0) {
      memory.fill(changetype<usize>(impulsesOf(t, id)), 0, IMPULSES_SIZE);
      putWord(t.started, id, 1);
    }
    if (<u32>word(t.kind, id) == FILTER) continue;
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
  clearTrees(t);
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
  const kind = <u32>word(t.kind, id);
  const hasAxes = kind >= MOTOR || get(t.hertz, id) > 0 || get(t.maxMotor, id) > 0 || word(t.hasLimits, id) != 0;
  if (hasAxes) putWord(t.axes, t.axisCount++, t.workCount);
  const work = clearWork(t, t.workCount++);
  work.id = id;
  work.kind = kind;
  if (hasAxes || !isHinge(work)) clearRows(work);
  work.impulseX = impulses.lock0;
  work.impulseY = impulses.lock1;
  work.localAx = <f64>get(t.ax, id);
  work.localAy = <f64>get(t.ay, id);
  work.localBx = <f64>get(t.bx, id);
  work.localBy = <f64>get(t.by, id);
  work.hasAxes = hasAxes ? 1 : 0;
  work.parent = word(t.parents, i);
  work.rowA = a;
  work.rowB = b;
  work.a = (flagsOf(rigid, a) & MOVES) != 0 ? a : 0;
  work.b = (flagsOf(rigid, b) & MOVES) != 0 ? b : 0;
  work.massA = <f64>poseOf(rigid, a).inverseMass;
  work.inertiaA = <f64>poseOf(rigid, a).inverseInertia;
  work.massB = <f64>poseOf(rigid, b).inverseMass;
  work.inertiaB = <f64>poseOf(rigid, b).inverseInertia;
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
