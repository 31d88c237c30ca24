// Brings the tree of what does not move up to date where few rows came or went, as where one digs or builds. To make it anew takes four times as
// long as a step of a large world at rest. A leaf of what is gone stays, without a row and with a box that is inside out; what came takes
// such a leaf, or goes beside the leaf that it is nearest to. The tree becomes worse by that, and is made anew after some changes.
import { STATIC, flagsOf, putWord, word } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { NODE, TreeNode, belongs, nodeAt } from './box-tree';
import { FatBox, copyBox, emptyBox, rowBox } from './fat-boxes';

// A smaller tree is made anew, which takes less than 0.05 ms.
const LEAST_NODES: i32 = 1000;
// Changes after which a tree is made anew.
const MOST_CHANGES: i32 = 64;

// The row of a leaf of which the body is gone.
const GONE: i32 = -1;

// Marks of rows, in the room of the list for making trees: not in the tree, to be in it, and in it.
const OUTSIDE: i32 = 0;
const WANTED: i32 = 1;
const INSIDE: i32 = 2;

// Returns whether the tree holds the rows that it should. Their boxes are to be brought up to date.
export function patchTree(t: RigidTable): bool {
  if (t.staticNodeCount < LEAST_NODES) return false;
  for (let row = 1; row < t.rows; row++) {
    putWord(t.treeRows, row, belongs(flagsOf(t, row), STATIC) ? WANTED : OUTSIDE);
  }
  for (let i = 0; i < t.staticNodeCount; i++) {
    const node = nodeAt(t.staticNodes, i);
    if (node.row <= 0) continue;
    if (node.row < t.rows && word(t.treeRows, node.row) == WANTED) putWord(t.treeRows, node.row, INSIDE);
    else if (!mayChange(t)) return false;
    else empty(node);
  }
  for (let row = 1; row < t.rows; row++) {
    if (word(t.treeRows, row) == WANTED && !(mayChange(t) && insert(t, row))) return false;
  }
  return true;
}

function mayChange(t: RigidTable): bool {
  return t.staticChanges++ < MOST_CHANGES;
}

// @ts-ignore: decorator
@inline function empty(node: TreeNode): void {
  node.row = GONE;
  node.changed = 0;
  emptyBox(changetype<FatBox>(node));
}

// Puts a row into the tree. Returns whether there was room.
function insert(t: RigidTable, row: i32): bool {
  const nodes = t.staticNodes;
  const box = rowBox(t, row);
  let at = 0;
  while (nodeAt(nodes, at).row == 0) {
    const first = nodeAt(nodes, at + 1);
    const second = nodeAt(nodes, first.skip);
    at = sizeWith(first, box) <= sizeWith(second, box) ? at + 1 : first.skip;
  }
  if (nodeAt(nodes, at).row != GONE) {
    if (t.staticNodeCount + 2 > 2 * t.rows) return false;
    divideLeaf(t, at);
    at += 2;
  }
  const leaf = nodeAt(nodes, at);
  leaf.row = row;
  copyBox(changetype<FatBox>(leaf), box);
  return true;
}

// The half perimeter of a box about a node and another box.
function sizeWith(node: TreeNode, box: FatBox): real {
  const x = max<real>(node.maxX, box.maxX) - min<real>(node.minX, box.minX);
  return x + max<real>(node.maxY, box.maxY) - min<real>(node.minY, box.minY);
}

// Puts a node in the place of a leaf, which becomes its first child, and room for another leaf behind that.
function divideLeaf(t: RigidTable, at: i32): void {
  const nodes = t.staticNodes;
  const count = t.staticNodeCount;
  const leaf = nodes + <usize>at * NODE;
  memory.copy(leaf + 3 * NODE, leaf + NODE, <usize>(count - at - 1) * NODE);
  memory.copy(leaf + NODE, leaf, NODE);
  for (let i = 0; i < at; i++) if (nodeAt(nodes, i).skip > at) nodeAt(nodes, i).skip += 2;
  for (let i = at + 3; i < count + 2; i++) nodeAt(nodes, i).skip += 2;
  nodeAt(nodes, at).row = 0;
  nodeAt(nodes, at).skip = at + 3;
  nodeAt(nodes, at + 1).skip = at + 2;
  nodeAt(nodes, at + 2).skip = at + 3;
  t.staticNodeCount = count + 2;
}
