// Joints that hang together as trees, so that all locked directions of a tree can be solved at once (solve-locks.ts). What
// does not move belongs to no tree: a bridge between two pillars is one tree, and so is a chain from the ceiling. A joint
// that closes a loop is left out and solved by itself, after the others.
import { putWord, word } from '../../solver/2d/body';
import { JointTable } from './joint-table';
import { nodeA, nodeB, workAt } from './joint-work';

export function orderTrees(t: JointTable): void {
  for (let i = 0; i < t.workCount; i++) {
    const work = workAt(t, i);
    for (let side = 0; side < 2; side++) {
      const row = side == 0 ? nodeA(work) : nodeB(work);
      putWord(t.sets, row, row);
      putWord(t.heads, row, -1);
    }
  }
  for (let i = 0; i < t.workCount; i++) linkJoint(t, i);
  t.orderCount = 0;
  t.rootCount = 0;
  for (let i = 0; i < t.workCount; i++) {
    const work = workAt(t, i);
    if (work.massA > 0) growTree(t, work.a);
    if (work.massB > 0) growTree(t, work.b);
  }
  // What is in no tree comes last.
  for (let i = 0; i < t.workCount; i++) if (workAt(t, i).parent == 0) putWord(t.order, t.orderCount++, i);
}

// Joins the sets of the two bodies, and lists the joint at each; not where both are in one set already.
function linkJoint(t: JointTable, i: i32): void {
  const work = workAt(t, i);
  work.parent = 0;
  const a = nodeA(work);
  const b = nodeB(work);
  if (a != 0 && b != 0) {
    const setA = setOf(t, a);
    const setB = setOf(t, b);
    if (setA == setB) return;
    putWord(t.sets, max<i32>(setA, setB), min<i32>(setA, setB));
  }
  // Until the tree has grown to it.
  work.parent = UNREACHED;
  if (a != 0) listAt(t, a, 2 * i);
  if (b != 0) listAt(t, b, 2 * i + 1);
}

const UNREACHED: i32 = 3;
const REACHED: i32 = -2;

function setOf(t: JointTable, row: i32): i32 {
  let set = row;
  while (word(t.sets, set) != set) {
    putWord(t.sets, set, word(t.sets, word(t.sets, set)));
    set = word(t.sets, set);
  }
  return set;
}

// @ts-ignore: decorator
@inline function listAt(t: JointTable, row: i32, entry: i32): void {
  putWord(t.next, entry, word(t.heads, row));
  putWord(t.heads, row, entry);
}

// Breadth first: t.order serves as the queue.
function growTree(t: JointTable, root: i32): void {
  if (word(t.heads, root) == REACHED) return;
  let at = t.orderCount;
  const before = at;
  reach(t, root);
  if (t.orderCount == before) return;
  putWord(t.roots, t.rootCount++, root);
  while (at < t.orderCount) {
    const work = workAt(t, word(t.order, at++));
    const child = work.parent == 1 ? nodeB(work) : nodeA(work);
    if (child != 0) reach(t, child);
  }
}

// Adds the joints of a body that no other has added.
function reach(t: JointTable, row: i32): void {
  let entry = word(t.heads, row);
  putWord(t.heads, row, REACHED);
  while (entry >= 0) {
    const work = workAt(t, entry >> 1);
    if (work.parent == UNREACHED) {
      work.parent = 1 + (entry & 1);
      putWord(t.order, t.orderCount++, entry >> 1);
    }
    entry = word(t.next, entry);
  }
}
