// A tree of boxes, for finding the boxes that overlap a given one. Its nodes lie in the order of a walk that visits a node, then
// all below it: the first child of a node follows it, and `skip` is the node behind all below it. So a query needs no
// stack, and boxes that changed are brought up to date in one pass from the end. A tree is made at once, from the top, by
// halving the extent of the centres. These lie side by side in a list of their own, which is read at every level.
import { add, laneOf, larger, mul, smaller, splat, sub } from '../../../memory/lanes';
import { FatBox, copyBox, overlaps, rowBox } from './fat-boxes';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { COLLIDES, ENLARGED, GROUPED, flagsOf, word } from '../../../solver/2d/body';

@unmanaged
export class TreeNode {
  minX: real;
  minY: real;
  maxX: real;
  maxY: real;
  skip: i32;
  // Of a leaf, below 0 if its body is gone (patch-tree.ts); 0 of an inner node.
  row: i32;
  // Whether a box in it changed in this step that may find others.
  changed: i32;
}

// @ts-ignore: decorator
@inline export const NODE: usize = (offsetof<TreeNode>() + sizeof<real>() - 1) & ~(sizeof<real>() - 1);

// @ts-ignore: decorator
@inline export function nodeAt(nodes: usize, i: i32): TreeNode {
  return changetype<TreeNode>(nodes + <usize>i * NODE);
}

// A row for which a tree is made, and twice the centre of its box. It has the size of a box, of one or two vectors.
@unmanaged
export class TreeRow {
  x: real;
  y: real;
  row: i32;
}

// @ts-ignore: decorator
@inline export const TREE_ROW_BLOCK: usize = 4 * sizeof<real>();

// @ts-ignore: decorator
@inline export function treeRowAt(t: RigidTable, i: i32): TreeRow {
  return changetype<TreeRow>(t.treeRows + <usize>i * TREE_ROW_BLOCK);
}

// The index of the first leaf from `i` on whose box overlaps another; `count` if there is none.
// @ts-ignore: decorator
@inline export function nextLeaf(nodes: usize, count: i32, i: i32, box: FatBox): i32 {
  let at = i;
  while (at < count) {
    const node = nodeAt(nodes, at);
    if (!overlaps(changetype<FatBox>(node), box)) at = node.skip;
    else if (node.row > 0) return at;
    else at++;
  }
  return count;
}

// Whether a box of the tree had changed when it was last brought up to date.
// @ts-ignore: decorator
@inline export function hasChanged(nodes: usize, count: i32): bool {
  return count > 0 && nodeAt(nodes, 0).changed != 0;
}

// Makes a tree of the boxes of all rows of such bodies, and returns the number of its nodes.
export function buildTree(t: RigidTable, nodes: usize, kinds: u32): i32 {
  return buildNodes(t, nodes, listRows(t, kinds));
}

// The same of the first rows of the list. Their boxes are to be written.
export function buildNodes(t: RigidTable, nodes: usize, count: i32): i32 {
  return count == 0 ? 0 : buildBelow(t, nodes, 0, 0, count);
}

// Whether a row with these flags is in a tree of such bodies.
// @ts-ignore: decorator
@inline export function belongs(flags: u32, kinds: u32): bool {
  return (flags & COLLIDES) != 0 && (flags & kinds) != 0;
}

function listRows(t: RigidTable, kinds: u32): i32 {
  let count = 0;
  for (let row = 1; row < t.rows; row++) {
    if (!belongs(flagsOf(t, row), kinds)) continue;
    const box = rowBox(t, row);
    const item = treeRowAt(t, count++);
    item.x = box.minX + box.maxX;
    item.y = box.minY + box.maxY;
    item.row = row;
  }
  return count;
}

// Makes the node with the rows [first, last) of the list, and returns the index behind it.
function buildBelow(t: RigidTable, nodes: usize, at: i32, first: i32, last: i32): i32 {
  const node = nodeAt(nodes, at);
  if (last - first == 1) {
    node.row = treeRowAt(t, first).row;
    node.skip = at + 1;
    return at + 1;
  }
  node.row = 0;
  const middle = divide(t, first, last);
  node.skip = buildBelow(t, nodes, buildBelow(t, nodes, at + 1, first, middle), middle, last);
  return node.skip;
}

// Puts the rows whose centre is in the lower half of the longer extent first, and returns where the others begin.
function divide(t: RigidTable, first: i32, last: i32): i32 {
  let least = splat(Infinity);
  let most = splat(-Infinity);
  for (let i = first; i < last; i++) {
    const centre = v128.load(changetype<usize>(treeRowAt(t, i)));
    least = smaller(least, centre);
    most = larger(most, centre);
  }
  const sum = mul(splat(0.5), add(least, most));
  const extent = sub(most, least);
  const middle =
    laneOf(extent, 0) >= laneOf(extent, 1)
      ? partition(t, first, last, laneOf(sum, 0), 0)
      : partition(t, first, last, laneOf(sum, 1), sizeof<real>());
  return middle == first || middle == last ? (first + last) >> 1 : middle;
}

// Puts the rows below a limit first. Every row changes places with the first that is not: whether it must is hard to predict.
// @ts-ignore: decorator
@inline function partition(t: RigidTable, first: i32, last: i32, limit: real, axis: usize): i32 {
  let middle = first;
  for (let i = first; i < last; i++) {
    const item = changetype<usize>(treeRowAt(t, i));
    const isBelow = load<real>(item + axis) < limit;
    exchange(item, changetype<usize>(treeRowAt(t, middle)));
    middle += i32(isBelow);
  }
  return middle;
}

// @ts-ignore: decorator
@inline function exchange(a: usize, b: usize): void {
  for (let offset: usize = 0; offset < TREE_ROW_BLOCK; offset += 16) {
    const value = v128.load(a + offset);
    v128.store(a + offset, v128.load(b + offset));
    v128.store(b + offset, value);
  }
}

// Whether a row looks for others: its box changed, and it collides with some layer, or with its group.
// @ts-ignore: decorator
@inline function mayFind(t: RigidTable, row: i32): bool {
  const flags = flagsOf(t, row);
  return (flags & ENLARGED) != 0 && (word(t.masks, row) != 0 || (flags & GROUPED) != 0);
}

// Brings the boxes of all nodes up to date, and returns the sum of their half perimeters.
export function refitTree(t: RigidTable, nodes: usize, count: i32): f64 {
  let perimeter: f64 = 0;
  for (let i = count - 1; i >= 0; i--) {
    const node = nodeAt(nodes, i);
    if (node.row < 0) continue;
    if (node.row != 0) {
      node.changed = mayFind(t, node.row) ? 1 : 0;
      copyBox(changetype<FatBox>(node), rowBox(t, node.row));
    } else {
      const a = nodeAt(nodes, i + 1);
      node.changed = a.changed | nodeAt(nodes, a.skip).changed;
      joinBoxes(nodes, i);
    }
    perimeter += <f64>(node.maxX - node.minX + node.maxY - node.minY);
  }
  return perimeter;
}

// Gives an inner node the box about those of its children.
// @ts-ignore: decorator
@inline export function joinBoxes(nodes: usize, i: i32): void {
  const node = nodeAt(nodes, i);
  const a = nodeAt(nodes, i + 1);
  const b = nodeAt(nodes, a.skip);
  node.minX = min<real>(a.minX, b.minX);
  node.minY = min<real>(a.minY, b.minY);
  node.maxX = max<real>(a.maxX, b.maxX);
  node.maxY = max<real>(a.maxY, b.maxY);
}
