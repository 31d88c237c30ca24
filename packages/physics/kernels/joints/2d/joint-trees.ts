// Joints that hang together as trees, so that all locked directions of a tree can be solved at once (solve-locks.ts). What
// does not move belongs to no tree: a bridge between two pillars is one tree, and so is a chain from the ceiling. A joint
// that closes a loop is left out and solved by itself, after the others.
import { get } from '../../memory/columns';
import { putWord, word } from '../../solver/2d/body';
import { clearBody } from './articulated-body';
import { DISTANCE, JointTable, MOTOR } from './joint-table';

// What t.parents holds of a joint: which body is its parent, that it closes a loop, or that no tree has grown to it yet.
export const LOOP: i32 = 0;
export const PARENT_A: i32 = 1;
const UNREACHED: i32 = 3;

// Of a body whose joints are in a tree: in the place of its first joint.
const REACHED: i32 = -2;

export function orderTrees(t: JointTable): void {
  const count = t.activeCount;
  for (let i = 0; i < 2 * count; i++) {
    const row = word(t.nodes, i);
    putWord(t.sets, row, row);
    putWord(t.heads, row, -1);
  }
  for (let i = 0; i < count; i++) linkJoint(t, i);
  t.orderCount = 0;
  t.rootCount = 0;
  for (let i = 0; i < 2 * count; i++) {
    const row = word(t.nodes, i);
    if (row != 0) growTree(t, row);
  }
  // Joints that close a loop come last.
  for (let i = 0; i < count; i++) if (word(t.parents, i) == LOOP) putWord(t.order, t.orderCount++, i);
}

// Joins the sets of the two bodies, and lists the joint at each; not where both are in one set already.
function linkJoint(t: JointTable, i: i32): void {
  const a = word(t.nodes, 2 * i);
  const b = word(t.nodes, 2 * i + 1);
  putWord(t.parents, i, LOOP);
  if (!locks(t, word(t.active, i))) return;
  if (a != 0 && b != 0) {
    const setA = setOf(t, a);
    const setB = setOf(t, b);
    if (setA == setB) return;
    putWord(t.sets, max<i32>(setA, setB), min<i32>(setA, setB));
  }
  putWord(t.parents, i, UNREACHED);
  if (a != 0) listAt(t, a, 2 * i);
  if (b != 0) listAt(t, b, 2 * i + 1);
}

// Whether a joint locks any direction. Others take no part in trees, where they would turn a chain of locks into a loop.
function locks(t: JointTable, id: i32): bool {
  const kind = <u32>word(t.kind, id);
  if (kind == DISTANCE) return !(get(t.hertz, id) > 0) && word(t.hasLimits, id) == 0;
  return kind < MOTOR;
}

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
  reach(t, root);
  if (t.orderCount == at) return;
  putWord(t.roots, t.rootCount++, root);
  while (at < t.orderCount) {
    const i = word(t.order, at++);
    const child = word(t.nodes, 2 * i + (word(t.parents, i) == PARENT_A ? 1 : 0));
    if (child != 0) reach(t, child);
  }
}

// Adds the joints of a body that no other has added.
function reach(t: JointTable, row: i32): void {
  let entry = word(t.heads, row);
  putWord(t.heads, row, REACHED);
  while (entry >= 0) {
    const i = entry >> 1;
    if (word(t.parents, i) == UNREACHED) {
      putWord(t.parents, i, PARENT_A + (entry & 1));
      putWord(t.order, t.orderCount++, i);
    }
    entry = word(t.next, entry);
  }
}

// Forgets what acts on the bodies of all trees. Each is a root or the child of one joint.
export function clearTrees(t: JointTable): void {
  for (let k = 0; k < t.rootCount; k++) clearBody(t, word(t.roots, k));
  for (let k = 0; k < t.orderCount; k++) {
    const i = word(t.order, k);
    const parent = word(t.parents, i);
    if (parent == LOOP) continue;
    const child = word(t.nodes, 2 * i + (parent == PARENT_A ? 1 : 0));
    if (child != 0) clearBody(t, child);
  }
}
