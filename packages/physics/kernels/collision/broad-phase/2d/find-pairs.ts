// The broad phase: pairs of bodies whose fat boxes overlap. Only boxes that changed look for others, so a pair is found when
// it begins to overlap; pairs that no longer do are dropped where contacts are updated.
import { COLLIDES, ENLARGED, MOVES, STATIC, flagsOf, putWord, word } from '../../../solver/2d/body';
import { bodyOf } from '../../../solver/2d/parts';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { addContacts } from '../../narrow-phase/2d/contact-list';
import { buildTree, nextLeaf, nodeAt, refitTree } from './box-tree';
import { rowBox, updateBoxes } from './fat-boxes';
import { areJoined, filtersMeet, keyOf, kindsMeet } from './pair-filter';
import { sortKeys } from './sort-keys';

// A tree whose boxes have grown by this factor is made anew.
const MAX_GROWTH: f64 = 1.5;

export function findRigidPairs(table: usize): void {
  const t = changetype<RigidTable>(table);
  updateBoxes(t);
  t.pairCount = 0;
  t.newPairCount = 0;
  if (t.enlargedCount == 0 && t.treesValid != 0) return;
  updateTrees(t);
  for (let i = 0; i < t.enlargedCount; i++) {
    const row = word(t.enlarged, i);
    // What collides with no layer finds nothing.
    if (word(t.masks, row) == 0) continue;
    findIn(t, t.movingNodes, t.movingNodeCount, row);
    if ((flagsOf(t, row) & MOVES) != 0) findIn(t, t.staticNodes, t.staticNodeCount, row);
  }
  sortKeys(t.pairs, t.sortedPairs, t.pairCount);
  addContacts(t);
}

function updateTrees(t: RigidTable): void {
  if (t.treesValid == 0) {
    t.staticNodeCount = buildTree(t, t.staticNodes, listRows(t, STATIC));
    refitTree(t, t.staticNodes, t.staticNodeCount);
    buildMovingTree(t);
    t.treesValid = 1;
    return;
  }
  if (staticEnlarged(t)) refitTree(t, t.staticNodes, t.staticNodeCount);
  if (refitTree(t, t.movingNodes, t.movingNodeCount) > MAX_GROWTH * t.builtPerimeter) buildMovingTree(t);
}

function buildMovingTree(t: RigidTable): void {
  t.movingNodeCount = buildTree(t, t.movingNodes, listRows(t, MOVES));
  t.builtPerimeter = refitTree(t, t.movingNodes, t.movingNodeCount);
}

function staticEnlarged(t: RigidTable): bool {
  for (let i = 0; i < t.enlargedCount; i++) if ((flagsOf(t, word(t.enlarged, i)) & STATIC) != 0) return true;
  return false;
}

// Lists the rows of such bodies with a shape for a tree.
function listRows(t: RigidTable, kinds: u32): i32 {
  let count = 0;
  for (let row = 1; row < t.rows; row++) {
    const flags = flagsOf(t, row);
    if ((flags & COLLIDES) != 0 && (flags & kinds) != 0) putWord(t.treeRows, count++, row);
  }
  return count;
}

// Notes the pairs of a row with those of a tree that its box overlaps.
function findIn(t: RigidTable, nodes: usize, count: i32, row: i32): void {
  const box = rowBox(t, row);
  for (let i = nextLeaf(nodes, count, 0, box); i < count; i = nextLeaf(nodes, count, i + 1, box)) {
    const other = nodeAt(nodes, i).row;
    if (mayCollide(t, row, other)) notePair(t, row, other);
  }
}

// A pair of which both looked for each other is noted by the first.
// @ts-ignore: decorator
@inline function mayCollide(t: RigidTable, row: i32, other: i32): bool {
  if (row == other) return false;
  const own = flagsOf(t, row);
  const others = flagsOf(t, other);
  if (!kindsMeet(own, others)) return false;
  if ((others & ENLARGED) != 0 && other < row && (own & others & MOVES) != 0) return false;
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
