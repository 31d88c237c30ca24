// The pairs of rows whose boxes overlap, of which one has changed. Two trees, or one with itself, are walked side by side, so that
// rows that are near each other share the way down: while everything moves, that takes a fraction of the tests of a walk for
// each row. Each pair is met once.
//
// Source: Ericson, Real-Time Collision Detection (2005), section 6.3.
import { flagsOf } from '../../../solver/2d/body';
import { bodyOf } from '../../../solver/2d/parts';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { TreeNode, nodeAt } from './box-tree';
import { FatBox, overlaps } from './fat-boxes';
import { areJoined, filtersMeet, keyOf, kindsMeet } from './pair-filter';

// Pairs of the tree below a node with itself.
export function findWithin(t: RigidTable, nodes: usize, at: i32): void {
  const node = nodeAt(nodes, at);
  if (node.row != 0 || node.changed == 0) return;
  const first = at + 1;
  const second = nodeAt(nodes, first).skip;
  findWithin(t, nodes, first);
  findWithin(t, nodes, second);
  findBetween(t, nodes, first, nodes, second);
}

// Pairs of what is below a node of one tree with what is below a node of another.
export function findBetween(t: RigidTable, nodesA: usize, a: i32, nodesB: usize, b: i32): void {
  if (haveNewPairs(nodeAt(nodesA, a), nodeAt(nodesB, b))) walk(t, nodesA, a, nodesB, b);
}

// @ts-ignore: decorator
@inline function haveNewPairs(a: TreeNode, b: TreeNode): bool {
  return (a.changed | b.changed) != 0 && overlaps(changetype<FatBox>(a), changetype<FatBox>(b));
}

// Goes on to the children of both nodes; a leaf stands for its own.
function walk(t: RigidTable, nodesA: usize, a: i32, nodesB: usize, b: i32): void {
  const nodeA = nodeAt(nodesA, a);
  const nodeB = nodeAt(nodesB, b);
  if (nodeA.row != 0 && nodeB.row != 0) {
    if ((nodeA.row | nodeB.row) > 0 && mayCollide(t, nodeA.row, nodeB.row)) notePair(t, nodeA.row, nodeB.row);
    return;
  }
  const firstB = nodeB.row == 0 ? b + 1 : b;
  for (let i = nodeA.row == 0 ? a + 1 : a; i < nodeA.skip; i = nodeAt(nodesA, i).skip) {
    for (let j = firstB; j < nodeB.skip; j = nodeAt(nodesB, j).skip) {
      if (haveNewPairs(nodeAt(nodesA, i), nodeAt(nodesB, j))) walk(t, nodesA, i, nodesB, j);
    }
  }
}

// @ts-ignore: decorator
@inline function mayCollide(t: RigidTable, row: i32, other: i32): bool {
  if (!kindsMeet(flagsOf(t, row), flagsOf(t, other))) return false;
  if (!filtersMeet(t, row, other)) return false;
  if (t.partCount == 0) return !areJoined(t, row, other);
  const body = bodyOf(t, row);
  const otherBody = bodyOf(t, other);
  return body != otherBody && !areJoined(t, body, otherBody);
}

// @ts-ignore: decorator
@inline function notePair(t: RigidTable, a: i32, b: i32): void {
  if (t.pairCount == t.pairCapacity) {
    t.droppedCount++;
    return;
  }
  store<u64>(t.pairs + ((<usize>t.pairCount) << 3), keyOf(a, b));
  t.pairCount++;
}
