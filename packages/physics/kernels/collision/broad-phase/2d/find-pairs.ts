// The broad phase: pairs of bodies whose fat boxes overlap. Only boxes that changed look for others, so a pair is found when
// it begins to overlap; pairs that no longer do are dropped where contacts are updated.
import { MOVES, STATIC } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { addContacts } from '../../narrow-phase/2d/contact-list';
import { buildTree, hasChanged, refitTree } from './box-tree';
import { updateBoxes } from './fat-boxes';
import { patchTree } from './patch-tree';
import { sortKeys } from './sort-keys';
import { findBetween, findWithin } from './tree-pairs';

// A tree whose boxes have grown by this factor is made anew.
const MAX_GROWTH: f64 = 1.5;

export function findRigidPairs(table: usize): void {
  const t = changetype<RigidTable>(table);
  updateBoxes(t);
  t.pairCount = 0;
  t.newPairCount = 0;
  if (t.enlargedCount == 0 && t.staticTreeValid != 0 && t.movingTreeValid != 0) return;
  updateStaticTree(t);
  updateMovingTree(t);
  // Pairs with static bodies come first: where there is no room for all pairs, these must not be dropped.
  if (t.movingNodeCount > 0) {
    if (t.staticNodeCount > 0) findBetween(t, t.movingNodes, 0, t.staticNodes, 0);
    findWithin(t, t.movingNodes, 0);
  }
  // A sensor at rest senses a lift that is put into it at rest.
  if (t.sensorCount > 0 && t.mayMoveCount > 0 && t.staticNodeCount > 0) findWithin(t, t.staticNodes, 0);
  sortKeys(t.pairs, t.sortedPairs, t.pairCount);
  addContacts(t);
}

function updateStaticTree(t: RigidTable): void {
  if (t.staticTreeValid == 0) {
    if (!patchTree(t)) {
      t.staticNodeCount = buildTree(t, t.staticNodes, STATIC);
      t.staticChanges = 0;
    }
    t.staticTreeValid = 1;
  } else if (t.enlargedStatics == 0 && !hasChanged(t.staticNodes, t.staticNodeCount)) {
    // Also in the step after a change they are brought up to date, which takes its marks away.
    return;
  }
  refitTree(t, t.staticNodes, t.staticNodeCount);
}

function updateMovingTree(t: RigidTable): void {
  if (t.movingTreeValid != 0 && refitTree(t, t.movingNodes, t.movingNodeCount) <= MAX_GROWTH * t.builtPerimeter) return;
  t.movingNodeCount = buildTree(t, t.movingNodes, MOVES);
  t.builtPerimeter = refitTree(t, t.movingNodes, t.movingNodeCount);
  t.movingTreeValid = 1;
}
