// Impacts at bodies that joints hold, before the first sub-step. In the sub-steps contacts and joints are solved in turn: a light foot
// would be stopped as if nothing stood on it, what it bears would go on, joints would be torn apart, and what pulls them together
// again would throw all back. So what is going to meet within the step is slowed now, together with all that joints hold to it,
// until it meets no sooner than at the end of the step. That takes energy and gives none. After the last sub-step what met is
// stopped. What bounces does not land: it gets its speed back after the last sub-step (restitution.ts).
import { LANES, splat } from '../../memory/lanes';
import { mayStrike } from '../../joints/2d/impact-locks';
import { JointTable } from '../../joints/2d/joint-table';
import { workAt } from '../../joints/2d/joint-work';
import { putWord, word } from '../../solver/2d/body';
import * as block from '../../solver/2d/contact-block';
import { willMeet } from '../../solver/2d/contact-place';
import { RigidTable } from '../../solver/2d/rigid-table';
import { firstEdge, linkContacts } from './contact-edges';
import { impactAt } from './impact';
import { addImpact, storeImpact } from './impact-list';
import { bounceInRounds, reachBody } from './impact-rounds';
import {
  endTrees,
  foreseeTrees,
  isJointed,
  lockJoints,
  memberOf,
  othersIn,
  startTrees,
  treeOf,
  unlockTrees,
} from './impact-trees';

// What approaches more slowly is left to the sub-steps, m/s.
const SLOW: real = 0.5;

// Whether the contact graph and the matrices of joints are made in this step.
let isLinked: bool = false;
let isReady: bool = false;

export function slowLandings(table: usize): void {
  const t = changetype<RigidTable>(table);
  t.impactCount = 0;
  t.landingCount = 0;
  t.approachingCount = 0;
  t.isLanding = 1;
  isLinked = false;
  isReady = false;
  listLandings(t);
  listStops(t);
  stopLandings(t);
  if (isReady) unlockTrees(t);
  for (let i = 0; i < t.impactCount; i++) putWord(t.struck, t.landingCount++, impactAt(t, i).place);
}

// After the last sub-step, which left to contacts what joints do not know of: stops what has landed. Returns whether there was anything.
export function endLandings(table: usize): i32 {
  const t = changetype<RigidTable>(table);
  if (t.landingCount == 0) return 0;
  t.impactCount = 0;
  t.isLanding = 1;
  linkContacts(t);
  startTrees(t);
  for (let i = 0; i < t.landingCount; i++) addImpact(t, word(t.struck, i));
  stopLandings(t);
  endTrees(t);
  return 1;
}

function stopLandings(t: RigidTable): void {
  if (t.impactCount > 0) bounceInRounds(t, SLOW);
  for (let i = 0; i < t.impactCount; i++) storeImpact(t, impactAt(t, i));
  t.isLanding = 0;
}

function listLandings(t: RigidTable): void {
  for (let i = 0; i < t.blockCount; i++) {
    const at = block.blockOf(t, i);
    const fast = v128.or(fastLanes(at + block.POINTS), fastLanes(at + block.POINTS + block.POINT));
    if (!v128.any_true(fast)) continue;
    for (let place = i * LANES; place < (i + 1) * LANES; place++) {
      if (!willMeet(t, place, SLOW) || !isJointed(t, place)) continue;
      getReady(t);
      addImpact(t, place);
    }
  }
}

// @ts-ignore: decorator
@inline function fastLanes(p: usize): v128 {
  return v128.lt<real>(v128.load(p, block.NORMAL_SPEED), splat(-SLOW));
}

// What stands on something and stops at a limit passes that on.
function listStops(t: RigidTable): void {
  const joints = changetype<JointTable>(t.joints);
  for (let k = 0; joints.otherCount > 0 && k < joints.treeCount; k++) {
    if (!mayStrike(joints, t, k, <f64>SLOW)) continue;
    link(t);
    const work = workAt(joints, k);
    const row = work.a != 0 ? work.a : work.b;
    const tree = treeOf(t, row);
    if (tree < 0 || !isTouched(t, row, tree)) continue;
    getReady(t);
    if (!lockJoints(t, tree, SLOW)) continue;
    for (let i = othersIn(t, tree); i >= 0; i--) reachBody(t, memberOf(t, row, tree, i), SLOW);
  }
}

function isTouched(t: RigidTable, row: i32, tree: i32): bool {
  for (let i = othersIn(t, tree); i >= 0; i--) {
    const member = memberOf(t, row, tree, i);
    if (member != 0 && firstEdge(t, member) >= 0) return true;
  }
  return false;
}

function getReady(t: RigidTable): void {
  if (isReady) return;
  isReady = true;
  link(t);
  foreseeTrees(t);
}

function link(t: RigidTable): void {
  if (!isLinked) linkContacts(t);
  isLinked = true;
}
