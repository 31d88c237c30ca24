// The broad phase: pairs of bodies whose fat boxes overlap. Only boxes that changed look for others, so a pair is found when
// it begins to overlap; pairs that no longer do are dropped where contacts are updated.
import { COLLIDES, MOVES, STATIC, flagsOf, putWord } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { addContacts } from '../../narrow-phase/2d/contact-list';
import { buildTree, hasChanged, refitTree } from './box-tree';
import { updateBoxes } from './fat-boxes';
import { sortKeys } from './sort-keys';
import { findBetween, findWithin } from './tree-pairs';

// A tree whose boxes have grown by this factor is made anew.
const MAX_GROWTH: f64 = 1.5;

export function findRigidPairs(table: usize): void {
  const t = changetype<RigidTable>(table);
  updateBoxes(t);
  t.pairCount = 0;
  t.newPairCount = 0;
  if (t.enlargedCount == 0 && t.treesValid != 0) return;
  updateTrees(t);
  if (t.movingNodeCount > 0) {
    findWithin(t, t.movingNodes, 0);
    if (t.staticNodeCount > 0) findBetween(t, t.movingNodes, 0, t.staticNodes, 0);
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
  // Also in the step after, which takes the marks of what has changed away.
  if (t.enlargedStatics > 0 || hasChanged(t.staticNodes, t.staticNodeCount))
    refitTree(t, t.staticNodes, t.staticNodeCount);
  if (refitTree(t, t.movingNodes, t.movingNodeCount) > MAX_GROWTH * t.builtPerimeter) buildMovingTree(t);
}

function buildMovingTree(t: RigidTable): void {
  t.movingNodeCount = buildTree(t, t.movingNodes, listRows(t, MOVES));
  t.builtPerimeter = refitTree(t, t.movingNodes, t.movingNodeCount);
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
