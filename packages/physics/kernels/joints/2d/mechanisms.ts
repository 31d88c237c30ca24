// Mechanisms: trees of joints with a few joints more, each of which closes a loop, and pulleys and gears, which may couple several
// trees. These joints are solved at once with their trees (close-loops.ts). In a net, which has as many loops as bodies, that would
// take too long: there they are solved by themselves.
import { putWord, word } from '../../solver/2d/body';
import { DISTANCE, JointTable } from './joint-table';
import { CLOSING, LOOP, setOf } from './joint-trees';
import { COUPLES, HINGE, LIMITED, LOCKS, POWERED, ROPE } from './list-active';

@unmanaged
export class Mechanism {
  // Its trees: the first in t.mechanismTrees, and their number.
  firstTree: i32;
  trees: i32;
  // Its joints that are in no tree: the index of the first among all joints, and their number.
  first: i32;
  count: i32;
  // How many directions they lock in this sub-step.
  rows: i32;
  // The factored matrix of these directions (close-loops.ts).
  matrix: usize;
}

const SIZE: usize = offsetof<Mechanism>();

// Joints of a mechanism that are in no tree lock at most so many directions, and these times the joints of its trees are at most so
// many: the time to make the matrix.
export const MATRIX_SIZE: usize = 96;
const MOST_WORK: i32 = 8192;

// @ts-ignore: decorator
@inline export function mechanismAt(t: JointTable, i: i32): Mechanism {
  return changetype<Mechanism>(t.mechanisms + <usize>i * SIZE);
}

// The number of the mechanism that a tree belongs to, or -1.
// @ts-ignore: decorator
@inline export function mechanismOf(t: JointTable, tree: i32): i32 {
  return t.mechanismCount > 0 ? word(t.mechanismOf, tree) - 1 : -1;
}

// The i-th tree of a mechanism.
// @ts-ignore: decorator
@inline export function treeOfMechanism(t: JointTable, mechanism: Mechanism, i: i32): i32 {
  return word(t.mechanismTrees, mechanism.firstTree + i);
}

// Finds the mechanisms among the trees, and lists their joints that are in no tree after those of the trees.
export function findMechanisms(t: JointTable): void {
  t.mechanismCount = 0;
  t.closedCount = t.treeCount;
  if (t.treeCount == t.activeCount) return;
  tallyTrees(t);
  let room = t.matrixRoom;
  let trees = 0;
  for (let r = 0; r < t.rootCount; r++) {
    const tally = tallyAt(t, r);
    const size = tally.rows * tally.rows;
    if (tally.group != r || size == 0 || size > room || !isSmall(tally)) continue;
    const mechanism = mechanismAt(t, t.mechanismCount++);
    mechanism.firstTree = trees;
    mechanism.trees = 0;
    mechanism.first = t.closedCount;
    mechanism.count = 0;
    mechanism.rows = 0;
    mechanism.matrix = t.matrices + ((<usize>(t.matrixRoom - room)) << 3);
    tally.mechanism = t.mechanismCount;
    trees += tally.trees;
    t.closedCount += tally.closing;
    room -= size;
  }
  for (let r = 0; r < t.rootCount; r++) listTree(t, r);
  for (let i = 0; i < t.activeCount; i++) if (canClose(t, i)) listClosing(t, i);
  t.orderCount = t.closedCount;
  for (let r = 0; r < t.rootCount; r++) putWord(t.marks, word(t.roots, r), 0);
}

function listTree(t: JointTable, r: i32): void {
  const number = tallyAt(t, groupAt(t, r)).mechanism;
  putWord(t.mechanismOf, r, number);
  if (number == 0) return;
  const mechanism = mechanismAt(t, number - 1);
  putWord(t.mechanismTrees, mechanism.firstTree + mechanism.trees++, r);
}

function listClosing(t: JointTable, i: i32): void {
  const number = tallyOf(t, i).mechanism;
  if (number == 0) return;
  const mechanism = mechanismAt(t, number - 1);
  putWord(t.parents, i, CLOSING);
  putWord(t.order, mechanism.first + mechanism.count++, i);
}

// Whether a joint closes a loop or couples bodies.
// @ts-ignore: decorator
@inline function canClose(t: JointTable, i: i32): bool {
  return word(t.parents, i) == LOOP && (word(t.roles, i) & (LOCKS | ROPE | COUPLES)) != 0;
}

// The most directions that a joint locks, with a limit and a motor: three, but for those that are many in mechanisms.
function rowsOf(t: JointTable, i: i32): i32 {
  const kind = <u32>word(t.kind, word(t.active, i));
  const role = word(t.roles, i);
  if ((role & COUPLES) != 0) return 1;
  // A rod may lock the direction across it, too (brace-rods.ts).
  const hasTwo = (role & HINGE) != 0 || kind == DISTANCE;
  return hasTwo && (role & (LIMITED | POWERED)) == 0 ? 2 : 3;
}

// What is counted of trees that hang together, in the record of the first of them. The memory is spare while joints are laid out.
@unmanaged
class Tally {
  // Of each tree: one that it hangs together with, at last the first.
  group: i32;
  trees: i32;
  joints: i32;
  // Joints in no tree, and how many directions they lock.
  closing: i32;
  rows: i32;
  // One more than the mechanism.
  mechanism: i32;
}

const TALLY: usize = offsetof<Tally>();

// @ts-ignore: decorator
@inline function tallyAt(t: JointTable, tree: i32): Tally {
  return changetype<Tally>(t.starts + <usize>tree * TALLY);
}

// Whether its matrix takes little enough time.
// @ts-ignore: decorator
@inline function isSmall(tally: Tally): bool {
  return tally.rows <= <i32>MATRIX_SIZE && tally.rows * tally.joints <= MOST_WORK;
}

function tallyTrees(t: JointTable): void {
  for (let r = 0; r < t.rootCount; r++) {
    putWord(t.marks, word(t.roots, r), r);
    memory.fill(changetype<usize>(tallyAt(t, r)), 0, TALLY);
    tallyAt(t, r).group = r;
  }
  for (let i = 0; i < t.activeCount; i++) if (canClose(t, i)) joinGroups(t, i);
  for (let r = 0; r < t.rootCount; r++) tallyAt(t, groupAt(t, r)).trees++;
  for (let k = 0; k < t.treeCount; k++) tallyOf(t, word(t.order, k)).joints++;
  for (let i = 0; i < t.activeCount; i++) {
    if (!canClose(t, i)) continue;
    const tally = tallyOf(t, i);
    tally.closing++;
    tally.rows += rowsOf(t, i);
  }
}

function joinGroups(t: JointTable, i: i32): void {
  const a = word(t.nodes, 2 * i);
  const b = word(t.nodes, 2 * i + 1);
  if (a == 0 || b == 0) return;
  const groupA = groupAt(t, treeAt(t, a));
  const groupB = groupAt(t, treeAt(t, b));
  tallyAt(t, max<i32>(groupA, groupB)).group = min<i32>(groupA, groupB);
}

// The first of the trees that hang together with one.
function groupAt(t: JointTable, tree: i32): i32 {
  let group = tree;
  while (tallyAt(t, group).group != group) group = tallyAt(t, group).group;
  return group;
}

// The number of the tree of a body, while joints are laid out.
// @ts-ignore: decorator
@inline function treeAt(t: JointTable, row: i32): i32 {
  return word(t.marks, setOf(t, row));
}

// @ts-ignore: decorator
@inline function tallyOf(t: JointTable, i: i32): Tally {
  const row = max<i32>(word(t.nodes, 2 * i), word(t.nodes, 2 * i + 1));
  return tallyAt(t, groupAt(t, treeAt(t, row)));
}
