// Joints that hang together as trees, so that all locked directions of a tree can be solved at once (solve-locks.ts). What
// does not move belongs to no tree: a bridge between two pillars is one tree, and so is a chain from the ceiling. A joint
// that closes a loop is left out and solved by itself, after the others.
import { putWord, word } from '../../solver/2d/body';
import { articulated } from './articulated-body';
import { JointTable } from './joint-table';
import { COUPLES, LOCKS, ROPE } from './list-active';

// What t.parents holds of a joint: which body is its parent, that it closes a loop, or that no tree has grown to it yet.
export const LOOP: i32 = 0;
export const PARENT_A: i32 = 1;
export const PARENT_B: i32 = 2;
// It closes a loop of a mechanism, or couples bodies of it (mechanisms.ts).
export const CLOSING: i32 = 3;
const UNREACHED: i32 = 4;

// Of a body whose joints are in a tree, in the place of its first joint: this less the index of the body in t.bodies.
const REACHED: i32 = -2;

// All trees grow at once, so that joints that wait for each other are far apart in the order.
export function orderTrees(t: JointTable): void {
  const count = t.activeCount;
  for (let i = 0; i < 2 * count; i++) {
    const row = word(t.nodes, i);
    putWord(t.sets, row, row);
    putWord(t.heads, row, -1);
    putWord(t.marks, row, 0);
    putWord(t.parents, i >> 1, LOOP);
  }
  // What locks nothing would turn a chain of locks into a loop; ropes that may be slack come after them.
  for (let i = 0; i < count; i++) linkJoint(t, i, LOCKS);
  for (let i = 0; i < count; i++) linkJoint(t, i, ROPE);
  listRoots(t);
  t.orderCount = 0;
  for (let r = 0; r < t.rootCount; r++) reach(t, word(t.roots, r), r);
  for (let at = 0; at < t.orderCount; at++) {
    const child = childOf(t, word(t.order, at));
    if (child != 0) reach(t, child, t.rootCount + at);
  }
  t.treeCount = t.orderCount;
}

// The first body of each tree: that with the smallest row.
function listRoots(t: JointTable): void {
  t.rootCount = 0;
  for (let i = 0; i < 2 * t.activeCount; i++) {
    const row = word(t.nodes, i);
    if (row == 0 || word(t.sets, row) != row || word(t.heads, row) < 0 || word(t.marks, row) != 0) continue;
    putWord(t.marks, row, 1);
    putWord(t.roots, t.rootCount++, row);
  }
  // What no joint but pulleys and gears holds is a tree by itself.
  for (let i = 0; i < 2 * t.activeCount; i++) {
    const row = word(t.nodes, i);
    if (row == 0 || (word(t.roles, i >> 1) & COUPLES) == 0 || word(t.marks, row) != 0) continue;
    if (word(t.sets, row) != row || word(t.heads, row) >= 0) continue;
    putWord(t.marks, row, 1);
    putWord(t.roots, t.rootCount++, row);
  }
  for (let r = 0; r < t.rootCount; r++) putWord(t.marks, word(t.roots, r), 0);
}

// The row of the body at the end of a joint that is not its parent, 0 where it does not move.
// @ts-ignore: decorator
@inline export function childOf(t: JointTable, i: i32): i32 {
  return word(t.nodes, 2 * i + (word(t.parents, i) == PARENT_A ? 1 : 0));
}

// The index in t.bodies of the parent of a joint in a tree.
// @ts-ignore: decorator
@inline export function indexAbove(t: JointTable, i: i32): i32 {
  return bodyIndexOf(t, word(t.nodes, 2 * i + (word(t.parents, i) == PARENT_A ? 0 : 1)));
}

// The index in t.bodies of a body of a tree.
// @ts-ignore: decorator
@inline export function bodyIndexOf(t: JointTable, row: i32): i32 {
  return REACHED - word(t.heads, row);
}

// A body of a tree, class ArticulatedBody, 0 for one that joints do not move.
// @ts-ignore: decorator
@inline export function treeBody(t: JointTable, row: i32): usize {
  if (row == 0) return 0;
  const index = bodyIndexOf(t, row);
  return index >= 0 && index < t.bodyCount && word(t.bodyRows, index) == row
    ? changetype<usize>(articulated(t, index))
    : 0;
}

// @ts-ignore: decorator
@inline export function isInTree(parent: i32): bool {
  return parent == PARENT_A || parent == PARENT_B;
}

// Joins the sets of the two bodies of a joint with this role, and lists it at each; not where both are in one set already.
function linkJoint(t: JointTable, i: i32, role: i32): void {
  const a = word(t.nodes, 2 * i);
  const b = word(t.nodes, 2 * i + 1);
  if ((word(t.roles, i) & role) == 0) return;
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

export function setOf(t: JointTable, row: i32): i32 {
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

// Adds the joints of a body that no other has added.
function reach(t: JointTable, row: i32, index: i32): void {
  let entry = word(t.heads, row);
  putWord(t.heads, row, REACHED - index);
  while (entry >= 0) {
    const i = entry >> 1;
    if (word(t.parents, i) == UNREACHED) {
      putWord(t.parents, i, PARENT_A + (entry & 1));
      putWord(t.order, t.orderCount++, i);
    }
    entry = word(t.next, entry);
  }
}
