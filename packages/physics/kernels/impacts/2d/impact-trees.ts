// Impacts at bodies that joints hold: what pushes one pushes its whole tree.
import { JointTable } from '../../joints/2d/joint-table';
import { bodyOfTree, jointsOfTree, treeOfRow } from '../../joints/2d/list-by-tree';
import { projectTree, projectTreeOnce, startProjections, startRound } from '../../joints/2d/project-trees';
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { Impact, ImpactPoint, applyNormalImpulse, impactAt, normalSpeedAt, pointOf } from './impact';

// Of a larger tree the bodies bounce one by one, and its joints follow after the last round: the time of a projection grows with the
// joints of the tree, and each contact of the tree needs some.
const MOST_JOINTS: i32 = 64;

// Points that joints let move apart by less than this part of what they would without joints are held.
const LEAST_MOTION: real = 1e-4;

// @ts-ignore: decorator
@inline function jointsOf(t: RigidTable): JointTable {
  return changetype<JointTable>(t.joints);
}

// Makes the joints ready for impacts.
export function startTrees(t: RigidTable): void {
  if (t.joints != 0) startProjections(jointsOf(t), t);
}

// The number of the tree with which a body bounces, or -1; `row` is 0 for what contacts do not push.
export function treeOf(t: RigidTable, row: i32): i32 {
  if (t.joints == 0 || row == 0) return -1;
  const tree = treeOfRow(jointsOf(t), row);
  return tree >= 0 && jointsOfTree(jointsOf(t), tree) <= MOST_JOINTS ? tree : -1;
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
  if (impact.treeA < 0 && impact.treeB < 0) return true;
  projectImpact(t, impact);
  const p = pointOf(impact, 0);
  if (impact.count < 2) return setMass(p, tryImpulse(t, impact, p, p));
  const q = pointOf(impact, 1);
  const pp = tryImpulse(t, impact, p, p);
  const qq = tryImpulse(t, impact, q, q);
  const most = sqrt<real>(pp * qq);
  impact.coupling = max<real>(-most, min<real>(most, tryImpulse(t, impact, p, q)));
  const moves = setMass(p, pp);
  return setMass(q, qq) && moves;
}

// Sets the effective mass of a point by what an impulse of 1 N s does, 1/kg.
function setMass(point: ImpactPoint, response: real): bool {
  const moves = response * point.mass > LEAST_MOTION;
  point.mass = <real>1 / response;
  return moves;
}

// The speed that an impulse of 1 N s at a point gives another, 1/kg: the larger of those there and back. They differ where a joint to
// what does not move, which is a little softer than rigid, leaves something for the next projection; too small a mass only takes more
// passes, too large a one would diverge.
function tryImpulse(t: RigidTable, impact: Impact, at: ImpactPoint, seen: ImpactPoint): real {
  const before = normalSpeedAt(impact, seen);
  applyNormalImpulse(impact, at, at.mass);
  projectImpact(t, impact);
  const pushed = normalSpeedAt(impact, seen);
  applyNormalImpulse(impact, at, -at.mass);
  projectImpact(t, impact);
  const there = pushed - before;
  const back = pushed - normalSpeedAt(impact, seen);
  return (abs<real>(there) > abs<real>(back) ? there : back) / at.mass;
}
