// Impacts at bodies that joints hold: what pushes one pushes its whole tree.
import { get } from '../../memory/columns';
import { lockBearing, lockStruck, releasePulling, unlockStruck } from '../../joints/2d/impact-locks';
import { JointTable } from '../../joints/2d/joint-table';
import { bendsOfTree, bodyOfTree, jointsOfTree, treeOfRow } from '../../joints/2d/list-by-tree';
import {
  foreseeProjections,
  projectAgain,
  projectTree,
  projectTreeOnce,
  startProjections,
  startRound,
} from '../../joints/2d/project-trees';
import { addResponse, endResponses, forgetResponses, responseOf } from '../../joints/2d/tree-responses';
import { BodyState, word } from '../../solver/2d/body';
import * as block from '../../solver/2d/contact-block';
import { blockAt, contactOf, laneAt } from '../../solver/2d/contact-place';
import { RigidTable } from '../../solver/2d/rigid-table';
import { Impact, ImpactPoint, applyNormalImpulse, impactAt, normalSpeedAt, pointOf } from './impact';

// Of a larger tree the bodies bounce one by one, and its joints follow after the last round: the time of an impulse grows with the
// joints of the tree, and each contact of the tree needs some. What bends needs many, as a rope that falls into a heap does. What is
// welded together would be torn apart at its loops and thrown back by them.
const MOST_BENDS: i32 = 64;
const MOST_JOINTS: i32 = 1024;

// Points that joints let move apart by less than this part of what they would without joints are held.
const LEAST_MOTION: real = 1e-4;

// The part of a contact's motion that joints must hold back before they count.
const LEAST_SHARE: real = 0.2;

// @ts-ignore: decorator
@inline function jointsOf(t: RigidTable): JointTable {
  return changetype<JointTable>(t.joints);
}

// Makes the joints ready for impacts.
export function startTrees(t: RigidTable): void {
  if (t.joints == 0) return;
  startProjections(jointsOf(t), t);
  forgetResponses(jointsOf(t));
  hasLocks = false;
}

// The same before the first sub-step.
export function foreseeTrees(t: RigidTable): void {
  foreseeProjections(jointsOf(t), t);
  forgetResponses(jointsOf(t));
}

// Ends landings before the first sub-step, which makes the matrices of joints again. Returns whether any were locked.
export function unlockTrees(t: RigidTable): bool {
  return unlockStruck(jointsOf(t));
}

// The same after the last sub-step.
export function endTrees(t: RigidTable): void {
  hasLocks = false;
  if (unlockTrees(t)) startProjections(jointsOf(t), t);
}

// Locks the limits and motors of a tree that an impact strikes.
export function lockJoints(t: RigidTable, tree: i32, slowest: real): bool {
  if (!lockStruck(jointsOf(t), t, tree, <f64>slowest)) return false;
  weighAgain(t, tree);
  return true;
}

// The same for the limits that bear a tree when something bounces there.
export function lockLimits(t: RigidTable, tree: i32): void {
  if (tree < 0 || !lockBearing(jointsOf(t), t, tree)) return;
  hasLocks = true;
  weighAgain(t, tree);
}

// Whether limits are locked in which bodies bounce.
export let hasLocks: bool = false;

// What is locked now counts in all impacts at the tree.
function weighAgain(t: RigidTable, tree: i32): void {
  projectAgain(jointsOf(t), t, tree);
  endResponses(jointsOf(t), tree);
  for (let i = 0; i < t.impactCount; i++) {
    const impact = impactAt(t, i);
    if (impact.treeA == tree || impact.treeB == tree) impact.isWeighed = 0;
  }
}

// Lets the limits of both trees of an impact go that had to pull. Returns whether there are any.
export function releaseLimits(t: RigidTable, impact: Impact): bool {
  const a = impact.treeA >= 0 && releasePulling(jointsOf(t), impact.treeA);
  if (a) weighAgain(t, impact.treeA);
  const b = impact.treeB >= 0 && impact.treeB != impact.treeA && releasePulling(jointsOf(t), impact.treeB);
  if (b) weighAgain(t, impact.treeB);
  return a || b;
}

// @ts-ignore: decorator
@inline function bouncesAsOne(t: JointTable, tree: i32): bool {
  return jointsOfTree(t, tree) <= MOST_JOINTS && bendsOfTree(t, tree) <= MOST_BENDS;
}

// The number of the tree with which a body bounces, or -1; `row` is 0 for what contacts do not push.
export function treeOf(t: RigidTable, row: i32): i32 {
  if (t.joints == 0 || row == 0) return -1;
  const tree = treeOfRow(jointsOf(t), row);
  return tree >= 0 && bouncesAsOne(jointsOf(t), tree) ? tree : -1;
}

// Whether what joints hold to the bodies of a contact may weigh in an impact: not where these are heavy against what hits them.
export function isJointed(t: RigidTable, place: i32): bool {
  const contact = contactOf(t, place);
  const isInTreeA = treeOf(t, contact.bodyA) >= 0;
  const isInTreeB = treeOf(t, contact.bodyB) >= 0;
  if (!isInTreeA && !isInTreeB) return false;
  const at = blockAt(t, place);
  const l = laneAt(place);
  const a = yieldOf(at, l, block.MASS_AX, block.MASS_AY, block.INERTIA_A, block.NORMAL_LEVER_A);
  const b = yieldOf(at, l, block.MASS_BX, block.MASS_BY, block.INERTIA_B, block.NORMAL_LEVER_B);
  return (isInTreeA ? a : 0) + (isInTreeB ? b : 0) > LEAST_SHARE * (a + b);
}

// How fast a body of a contact moves by an impulse of 1 N s at the first point, 1/kg: where its numbers are in the block.
function yieldOf(at: usize, l: i32, massX: usize, massY: usize, inertia: usize, lever: usize): real {
  const nx = get(at + block.NX, l);
  const ny = get(at + block.NY, l);
  const arm = get(at + block.POINTS + lever, l);
  return get(at + massX, l) * nx * nx + get(at + massY, l) * ny * ny + get(at + inertia, l) * arm * arm;
}

// Of a body and all that bounces with it: how many there are, besides one, and their rows, 0 where there is none.
// @ts-ignore: decorator
@inline export function othersIn(t: RigidTable, tree: i32): i32 {
  return tree < 0 ? 0 : jointsOfTree(jointsOf(t), tree);
}

// @ts-ignore: decorator
@inline export function memberOf(t: RigidTable, row: i32, tree: i32, i: i32): i32 {
  return tree < 0 ? row : bodyOfTree(jointsOf(t), tree, i);
}

// Passes an impulse on to all that joints hold to both bodies.
export function projectImpact(t: RigidTable, impact: Impact): void {
  if (impact.treeA >= 0) projectTree(jointsOf(t), t, impact.treeA);
  if (impact.treeB >= 0 && impact.treeB != impact.treeA) projectTree(jointsOf(t), t, impact.treeB);
}

// The velocities of both bodies of an impact before an impulse, and the columns with which their trees follow it, 0 for none.
let oldVxA: real = 0;
let oldVyA: real = 0;
let oldWA: real = 0;
let oldVxB: real = 0;
let oldVyB: real = 0;
let oldWB: real = 0;
let columnsA: usize = 0;
let columnsB: usize = 0;

// Makes an impact ready for an impulse.
export function startImpulse(t: RigidTable, impact: Impact): void {
  if (impact.treeA < 0 && impact.treeB < 0) return;
  columnsA = impact.treeA < 0 ? 0 : responseOf(jointsOf(t), t, impact.treeA, impact.rowA);
  columnsB = impact.treeB < 0 ? 0 : responseOf(jointsOf(t), t, impact.treeB, impact.rowB);
  // A tree that both are in follows both in one way.
  if (impact.treeA == impact.treeB && (columnsA == 0 || columnsB == 0)) {
    columnsA = 0;
    columnsB = 0;
  }
  const a = changetype<BodyState>(impact.stateA);
  const b = changetype<BodyState>(impact.stateB);
  oldVxA = a.vx;
  oldVyA = a.vy;
  oldWA = a.w;
  oldVxB = b.vx;
  oldVyB = b.vy;
  oldWB = b.w;
}

// Passes the impulse since then on to all that joints hold to both bodies.
export function passImpulse(t: RigidTable, impact: Impact): void {
  if (impact.treeA < 0 && impact.treeB < 0) return;
  const a = changetype<BodyState>(impact.stateA);
  const b = changetype<BodyState>(impact.stateB);
  const dxA = a.vx - oldVxA;
  const dyA = a.vy - oldVyA;
  const dwA = a.w - oldWA;
  const dxB = b.vx - oldVxB;
  const dyB = b.vy - oldVyB;
  const dwB = b.w - oldWB;
  if (columnsA != 0) {
    a.vx = oldVxA;
    a.vy = oldVyA;
    a.w = oldWA;
  } else if (impact.treeA >= 0) projectTree(jointsOf(t), t, impact.treeA);
  if (columnsB != 0) {
    b.vx = oldVxB;
    b.vy = oldVyB;
    b.w = oldWB;
  } else if (impact.treeB >= 0 && impact.treeB != impact.treeA) projectTree(jointsOf(t), t, impact.treeB);
  if (columnsA != 0) addResponse(jointsOf(t), t, impact.treeA, columnsA, dxA, dyA, dwA);
  if (columnsB != 0) addResponse(jointsOf(t), t, impact.treeB, columnsB, dxB, dyB, dwB);
}

// The same of the impulses of all impacts, by one projection a tree.
export function projectImpacts(t: RigidTable): void {
  if (t.joints == 0) return;
  startRound(jointsOf(t));
  for (let i = 0; i < t.impactCount; i++) projectOnce(t, impactAt(t, i));
}

export function projectStruck(t: RigidTable): void {
  if (t.joints == 0) return;
  startRound(jointsOf(t));
  for (let i = 0; i < t.struckCount; i++) projectOnce(t, impactAt(t, word(t.struck, i)));
}

// @ts-ignore: decorator
@inline function projectOnce(t: RigidTable, impact: Impact): void {
  if (impact.treeA >= 0) projectTreeOnce(jointsOf(t), t, impact.treeA);
  if (impact.treeB >= 0) projectTreeOnce(jointsOf(t), t, impact.treeB);
}

// Measures the effective masses of a contact with all that joints hold to its bodies, by impulses that are taken back. Returns
// false if joints keep its points where they are.
export function weighTrees(t: RigidTable, impact: Impact): bool {
  impact.isWeighed = 1;
  if (impact.treeA < 0 && impact.treeB < 0) return true;
  // What is welded cannot move apart.
  if (impact.treeA == impact.treeB && bendsOfTree(jointsOf(t), impact.treeA) == 0) return false;
  startImpulse(t, impact);
  if (columnsA == 0 && columnsB == 0) projectImpact(t, impact);
  const p = pointOf(impact, 0);
  const q = pointOf(impact, 1);
  const pp = tryImpulse(t, impact, p, q);
  const pq = otherResponse;
  if (impact.count < 2) return setMass(p, pp);
  const qq = tryImpulse(t, impact, q, p);
  const most = sqrt<real>(pp * qq);
  impact.coupling = max<real>(-most, min<real>(most, pq));
  const moves = setMass(p, pp);
  return setMass(q, qq) && moves;
}

// Sets the effective mass of a point by what an impulse of 1 N s does, 1/kg.
function setMass(point: ImpactPoint, response: real): bool {
  if (!(response * point.ownMass > LEAST_MOTION)) return false;
  point.mass = <real>1 / response;
  return true;
}

// The same of the other point, after `tryImpulse`.
let otherResponse: real = 0;

// The speed that an impulse of 1 N s at a point gives it, 1/kg: the larger of those there and back. They differ where a joint to
// what does not move, which is a little softer than rigid, leaves something for the next projection; too small a mass only takes more
// passes, too large a one would diverge.
function tryImpulse(t: RigidTable, impact: Impact, at: ImpactPoint, other: ImpactPoint): real {
  const first = normalSpeedAt(impact, at);
  const firstOther = normalSpeedAt(impact, other);
  startImpulse(t, impact);
  applyNormalImpulse(impact, at, at.ownMass);
  passImpulse(t, impact);
  const pushed = normalSpeedAt(impact, at);
  const pushedOther = normalSpeedAt(impact, other);
  startImpulse(t, impact);
  applyNormalImpulse(impact, at, -at.ownMass);
  passImpulse(t, impact);
  otherResponse = larger(pushedOther - firstOther, pushedOther - normalSpeedAt(impact, other)) / at.ownMass;
  return larger(pushed - first, pushed - normalSpeedAt(impact, at)) / at.ownMass;
}

// @ts-ignore: decorator
@inline function larger(a: real, b: real): real {
  return abs<real>(a) > abs<real>(b) ? a : b;
}
