// Mechanisms: trees of joints with a few joints more, each of which closes a loop. These are solved at once with their tree
// (close-loops.ts). In a net, which has as many loops as bodies, that would take too long: there joints that close loops are
// solved by themselves, after the trees.
import { putWord, word } from '../../solver/2d/body';
import { DISTANCE, JointTable, PRISMATIC, REVOLUTE, WELD } from './joint-table';
import { CLOSING, LOOP, setOf } from './joint-trees';
import { LIMITED, LOCKS, ROPE } from './list-active';

@unmanaged
export class Mechanism {
  tree: i32;
  // Its joints that close loops: the index of the first among all joints, and their number.
  first: i32;
  count: i32;
  // How many directions they lock in this sub-step.
  rows: i32;
  // The factored matrix of these directions (close-loops.ts).
  matrix: usize;
}

const SIZE: usize = offsetof<Mechanism>();

// A mechanism locks at most so many directions at its loops, and these times the joints of its tree are at most so many: the time
// to make the matrix.
export const MATRIX_SIZE: usize = 96;
const MOST_WORK: i32 = 8192;

// @ts-ignore: decorator
@inline export function mechanismAt(t: JointTable, i: i32): Mechanism {
  return changetype<Mechanism>(t.mechanisms + <usize>i * SIZE);
}

// Finds the mechanisms among the trees, and lists their joints that close loops after those of the trees.
export function findMechanisms(t: JointTable): void {
  t.mechanismCount = 0;
  t.closedCount = t.treeCount;
  if (t.treeCount == t.activeCount) return;
  for (let r = 0; r < t.rootCount; r++) {
    putWord(t.marks, word(t.roots, r), r);
    memory.fill(tallyAt(t, r), 0, TALLY);
  }
  for (let k = 0; k < t.treeCount; k++) tallyOf(t, word(t.order, k)).joints++;
  for (let i = 0; i < t.activeCount; i++) {
    if (!closesLoop(t, i)) continue;
    const tally = tallyOf(t, i);
    tally.loops++;
    tally.rows += rowsOf(t, i);
  }
  let room = t.matrixRoom;
  for (let r = 0; r < t.rootCount; r++) room -= addMechanism(t, r, room);
  for (let i = 0; i < t.activeCount; i++) {
    if (!closesLoop(t, i) || tallyOf(t, i).mechanism == 0) continue;
    const mechanism = mechanismAt(t, tallyOf(t, i).mechanism - 1);
    putWord(t.parents, i, CLOSING);
    putWord(t.order, mechanism.first + mechanism.count++, i);
  }
  t.orderCount = t.closedCount;
  for (let r = 0; r < t.rootCount; r++) putWord(t.marks, word(t.roots, r), 0);
}

// Makes a mechanism of a tree, if its loops are few and their matrix has room. Returns the size of that.
function addMechanism(t: JointTable, tree: i32, room: i32): i32 {
  const tally = changetype<Tally>(tallyAt(t, tree));
  const rows = tally.rows;
  const size = rows * rows;
  if (rows == 0 || rows > <i32>MATRIX_SIZE || rows * tally.joints > MOST_WORK || size > room) return 0;
  const mechanism = mechanismAt(t, t.mechanismCount++);
  mechanism.tree = tree;
  mechanism.first = t.closedCount;
  mechanism.count = 0;
  mechanism.rows = 0;
  mechanism.matrix = t.matrices + ((<usize>(t.matrixRoom - room)) << 3);
  t.closedCount += tally.loops;
  tally.mechanism = t.mechanismCount;
  return size;
}

// @ts-ignore: decorator
@inline function closesLoop(t: JointTable, i: i32): bool {
  return word(t.parents, i) == LOOP && (word(t.roles, i) & (LOCKS | ROPE)) != 0;
}

// The most directions that a joint locks, with its limits.
function rowsOf(t: JointTable, i: i32): i32 {
  const kind = <u32>word(t.kind, word(t.active, i));
  const role = word(t.roles, i);
  const limit = (role & LIMITED) != 0 ? 1 : 0;
  if ((role & ROPE) != 0 || kind == DISTANCE) return 1;
  if (kind == WELD) return 3;
  return limit + (kind == REVOLUTE || kind == PRISMATIC ? 2 : 1);
}

// What is counted of a tree, in memory that is spare while joints are laid out.
@unmanaged
class Tally {
  joints: i32;
  loops: i32;
  rows: i32;
  // One more than its mechanism.
  mechanism: i32;
}

const TALLY: usize = offsetof<Tally>();

// @ts-ignore: decorator
@inline function tallyAt(t: JointTable, tree: i32): usize {
  return t.starts + <usize>tree * TALLY;
}

// @ts-ignore: decorator
@inline function tallyOf(t: JointTable, i: i32): Tally {
  const row = max<i32>(word(t.nodes, 2 * i), word(t.nodes, 2 * i + 1));
  return changetype<Tally>(tallyAt(t, word(t.marks, setOf(t, row))));
}

// The mechanism of a tree, or -1, once all are laid out.
export function mechanismOf(t: JointTable, tree: i32): i32 {
  let low = 0;
  let high = t.mechanismCount;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (mechanismAt(t, middle).tree < tree) low = middle + 1;
    else high = middle;
  }
  return low < t.mechanismCount && mechanismAt(t, low).tree == tree ? low : -1;
}
