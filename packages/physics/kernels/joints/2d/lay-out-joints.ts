// Lays out the joints that act, with what stays as it is until others do: where each stands in its tree, which bodies it has,
// and what it has exerted.
import { putWord, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { ARTICULATED_BODY_SIZE, ARTICULATED_MASS_SIZE, articulated } from './articulated-body';
import { startJointed } from './brace-joints';
import { colorLoops, layOutLoops } from './color-loops';
import { countSprings } from './count-springs';
import { JointTable, impulsesOf } from './joint-table';
import { CLOSING, PARENT_B, childOf, indexAbove, isInTree, orderTrees, setOf } from './joint-trees';
import { JointPlace, PLAIN, WARM, clearRows, placeAt, signOf, workAt } from './joint-work';
import { forgetTrees, listByTree } from './list-by-tree';
import { AXES, A_MOVES, B_MOVES, HINGE, LIMITED, LOCKED_END, POWERED, SPRING, dropUnused } from './list-active';
import { findMechanisms } from './mechanisms';

export function layOutJoints(t: JointTable, rigid: RigidTable): void {
  dropUnused(t);
  forgetTrees(t);
  orderTrees(t);
  findMechanisms(t);
  colorLoops(t);
  layOutLoops(t, rigid);
  t.workCount = t.orderCount;
  t.axisCount = 0;
  t.otherCount = 0;
  t.bodyCount = t.rootCount + t.treeCount;
  memory.fill(t.bodies, 0, <usize>t.bodyCount * ARTICULATED_BODY_SIZE);
  memory.fill(t.masses, 0, <usize>t.bodyCount * ARTICULATED_MASS_SIZE);
  for (let i = 0; i < 2 * t.activeCount; i++) startJointed(t, rigid, word(t.ends, i));
  startJointed(t, rigid, 0);
  for (let r = 0; r < t.rootCount; r++) putWord(t.bodyRows, r, word(t.roots, r));
  markWarmTrees(t);
  for (let k = 0; k < t.workCount; k++) layOutJoint(t, k);
  listByTree(t);
  countSprings(t);
}

// Marks the sets of bodies whose joints must begin with what they exerted.
function markWarmTrees(t: JointTable): void {
  for (let i = 0; i < 2 * t.activeCount; i++) putWord(t.marks, word(t.nodes, i), 0);
  for (let i = 0; i < t.activeCount; i++) {
    if ((word(t.roles, i) & (AXES | LOCKED_END)) == 0 && word(t.parents, i) != CLOSING) continue;
    putWord(t.marks, setOf(t, word(t.nodes, 2 * i)), 1);
    putWord(t.marks, setOf(t, word(t.nodes, 2 * i + 1)), 1);
  }
}

// @ts-ignore: decorator
@inline function isWarm(t: JointTable, i: i32): bool {
  const row = max<i32>(word(t.nodes, 2 * i), word(t.nodes, 2 * i + 1));
  return word(t.marks, setOf(t, row)) != 0;
}

function layOutJoint(t: JointTable, k: i32): void {
  const i = word(t.order, k);
  const id = word(t.active, i);
  const role = word(t.roles, i);
  const work = workAt(t, k);
  work.id = id;
  work.kind = <u32>word(t.kind, id);
  work.hasAxes = (role & AXES) != 0 ? 1 : 0;
  work.rowA = word(t.ends, 2 * i);
  work.rowB = word(t.ends, 2 * i + 1);
  work.a = (role & A_MOVES) != 0 ? work.rowA : 0;
  work.b = (role & B_MOVES) != 0 ? work.rowB : 0;
  if (work.hasAxes != 0) putWord(t.axes, t.axisCount++, k);
  const at = placeAt(t, k);
  at.id = id;
  at.parent = word(t.parents, i);
  // A hinge that has a spring, limits or a motor, or closes a loop and stands in no block, is solved by rows, as other joints are.
  const isHinge = (role & (HINGE | SPRING | LIMITED | POWERED)) == HINGE && isInTree(at.parent);
  at.hinge = !isHinge ? 0 : isWarm(t, i) ? WARM : PLAIN;
  if (at.hinge != PLAIN) {
    t.otherCount++;
    clearRows(t, k);
  }
  work.parent = at.parent;
  work.limit = 0;
  work.motor = 0;
  work.motorLock = -1;
  work.springLock = -1;
  work.push = 0;
  work.springPush = 0;
  work.springs = 1;
  work.acrossInverse = 0;
  work.reach = 1;
  at.parentRow = at.parent == PARENT_B ? work.b : work.a;
  at.childRow = at.parent == PARENT_B ? work.a : work.b;
  at.impulseX = signOf(at) * impulsesOf(t, id).lock0;
  at.impulseY = signOf(at) * impulsesOf(t, id).lock1;
  placeInTree(t, at, i, k);
}

// @ts-ignore: decorator
@inline function placeInTree(t: JointTable, at: JointPlace, i: i32, k: i32): void {
  at.above = 0;
  at.below = 0;
  if (!isInTree(at.parent)) return;
  at.above = changetype<usize>(articulated(t, indexAbove(t, i)));
  putWord(t.bodyRows, t.rootCount + k, childOf(t, i));
  if (childOf(t, i) != 0) at.below = changetype<usize>(articulated(t, t.rootCount + k));
}
