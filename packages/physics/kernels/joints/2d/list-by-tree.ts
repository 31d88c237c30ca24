// The trees of joints one by one, for what changes one and no other.
import { putWord, word } from '../../solver/2d/body';
import { JointTable } from './joint-table';
import { isInTree } from './joint-trees';
import { placeAt } from './joint-work';
import { isRigid } from './list-active';

// Takes all bodies out of their trees.
export function forgetTrees(t: JointTable): void {
  for (let i = 0; i < t.bodyCount; i++) putWord(t.treeOf, word(t.bodyRows, i), 0);
}

// Lists the joints by tree, in the order that they have among all, parents first.
export function listByTree(t: JointTable): void {
  memory.fill(t.treeStarts, 0, (<usize>(t.rootCount + 2)) << 2);
  for (let tree = 0; tree < t.rootCount; tree++) {
    putWord(t.treeOf, word(t.roots, tree), tree + 1);
    putWord(t.bends, tree, 0);
    putWord(t.loops, tree, 0);
  }
  // How many joints each tree has, two places further: `append` moves the starts by one place.
  for (let k = 0; k < t.treeCount; k++) {
    const tree = treeOfRow(t, placeAt(t, k).parentRow);
    if (placeAt(t, k).below != 0) putWord(t.treeOf, placeAt(t, k).childRow, tree + 1);
    putWord(t.treeStarts, tree + 2, word(t.treeStarts, tree + 2) + 1);
    if (!isRigid(word(t.roles, word(t.order, k)))) putWord(t.bends, tree, word(t.bends, tree) + 1);
  }
  for (let tree = 1; tree <= t.rootCount; tree++) {
    putWord(t.treeStarts, tree + 1, word(t.treeStarts, tree) + word(t.treeStarts, tree + 1));
  }
  for (let k = 0; k < t.treeCount; k++) append(t, treeOfRow(t, placeAt(t, k).parentRow), k);
  for (let i = 0; i < t.activeCount; i++) {
    if (isInTree(word(t.parents, i))) continue;
    noteLoop(t, word(t.nodes, 2 * i));
    noteLoop(t, word(t.nodes, 2 * i + 1));
  }
}

function noteLoop(t: JointTable, row: i32): void {
  if (row != 0 && treeOfRow(t, row) >= 0) putWord(t.loops, treeOfRow(t, row), 1);
}

function append(t: JointTable, tree: i32, k: i32): void {
  const end = word(t.treeStarts, tree + 1);
  putWord(t.treeJoints, end, k);
  putWord(t.treeStarts, tree + 1, end + 1);
}

// The number of the tree that a body is in, -1 for none.
// @ts-ignore: decorator
@inline export function treeOfRow(t: JointTable, row: i32): i32 {
  return word(t.treeOf, row) - 1;
}

// @ts-ignore: decorator
@inline export function jointsOfTree(t: JointTable, tree: i32): i32 {
  return word(t.treeStarts, tree + 1) - word(t.treeStarts, tree);
}

// How many joints of a tree let it bend: all but rigid welds.
// @ts-ignore: decorator
@inline export function bendsOfTree(t: JointTable, tree: i32): i32 {
  return word(t.bends, tree);
}

// The row of the first body of a tree, and for i > 0 that of the child of its i-th joint, 0 where joints do not move it.
export function bodyOfTree(t: JointTable, tree: i32, i: i32): i32 {
  if (i == 0) return word(t.roots, tree);
  const at = placeAt(t, word(t.treeJoints, word(t.treeStarts, tree) + i - 1));
  return at.below != 0 ? at.childRow : 0;
}
