// Hinges of trees that are torn far apart, as where a slack chain is stretched with a jerk by a heavy load. Velocities do not bring
// them together again: what closes all gaps with the least energy does not lift the load but turns the light links, by more than a
// sub-step can follow, and opens further gaps; the load would fall for ever. So such hinges only hold the speeds of their points, and
// bodies are moved together after the sub-steps, without velocities: from the root of a tree to its ends each by a part of the gap above it,
//
//   s = s' - min(k dt, d/|C|) C        s': of the parent, C: the gap, d: the most that a gap changes in a step
//
// and then all of them by what leaves the ends that do not move where they are, or else the centre of mass.
// Source: the positions are those of nonlinear position correction (Catto, Modeling and Solving Constraints, GDC 2009), in the order of
// the tree.
import { dot2, loadReals, minus, plus, storeReals, times, turnedBy, vector } from '../../math/vector-2d';
import { BodyState, stateOf, word } from '../../solver/2d/body';
import { inverseMassX, inverseMassY } from '../../solver/2d/motion-locks';
import { RigidTable } from '../../solver/2d/rigid-table';
import { ARTICULATED_BODY_SIZE, ArticulatedBody, articulated } from './articulated-body';
import {
  momentumBelow,
  movementOf,
  setMomentumBelow,
  setValue,
  startBetween,
  startOfChild,
  startOfParent,
  turnOf,
  valueOf,
} from './hinge-vectors';
import { MOST_ERROR } from './joint-rows';
import { JointTable } from './joint-table';
import { JointPlace, placeAt, startAt } from './joint-work';
import { bodyOfTree, jointsOfTree, treeOfRow } from './list-by-tree';

// The square of the gap beyond which a hinge is torn, m². In chains that swing with a hundred times the mass of a link gaps are below
// 1 mm; 10 cm would leave those between apart, which keep opening others.
export const TORN: f64 = 0.02 * 0.02;

// The rate k at which gaps close, 1/s.
const RATE: f64 = 15;

// Whether a hinge with such a gap is brought together by positions, and not by velocities. Notes it.
export function isTorn(t: JointTable, at: JointPlace): bool {
  if (!isFree(t, treeOfRow(t, at.parentRow))) return false;
  t.tornCount++;
  return true;
}

// Whether the bodies of a tree may be moved so: joints close no loops in it, and no contact is in the way, through which they would pass.
function isFree(t: JointTable, tree: i32): bool {
  if (tree < 0 || word(t.loops, tree) != 0) return false;
  const usedColors = changetype<RigidTable>(t.rigid).usedColors;
  for (let i = jointsOfTree(t, tree); i >= 0; i--) {
    const row = bodyOfTree(t, tree, i);
    if (row != 0 && word(usedColors, row) != 0) return false;
  }
  return true;
}

// Moves bodies after the last sub-step.
export function closeTorn(table: usize): void {
  const t = changetype<JointTable>(table);
  if (t.tornCount == 0) return;
  t.tornCount = 0;
  const rigid = changetype<RigidTable>(t.rigid);
  const part = min<f64>(1, RATE * rigid.dt);
  for (let k = 0; k < t.treeCount; k++) shiftChild(t, rigid, placeAt(t, k), k, part);
  for (let k = 0; k < t.treeCount; k++) weighShift(t, placeAt(t, k));
  for (let r = 0; r < t.rootCount; r++) {
    const root = articulated(t, r);
    const sum = root.gw != 0 ? abs<f64>(root.gw) : 1;
    setMomentumBelow(root, times(1 / sum, momentumBelow(root)));
    move(rigid, word(t.roots, r), momentumBelow(root));
  }
  for (let k = 0; k < t.treeCount; k++) {
    const at = placeAt(t, k);
    if (at.below != 0) move(rigid, at.childRow, plus(momentumBelow(rootOf(t, at)), valueOf(at)));
  }
  for (let r = 0; r < t.rootCount; r++) {
    setMomentumBelow(articulated(t, r), f64x2.splat(0));
    articulated(t, r).gw = 0;
  }
}

// @ts-ignore: decorator
@inline function rootOf(t: JointTable, at: JointPlace): ArticulatedBody {
  return articulated(t, treeOfRow(t, at.parentRow));
}

// Finds the shift of a child beside that of the root, or, of an end that does not move, by how much the tree is to move: its sum, and the
// number of such ends, are kept with the root.
function shiftChild(t: JointTable, rigid: RigidTable, at: JointPlace, k: i32, part: f64): void {
  const above = <i32>((at.above - t.bodies) / ARTICULATED_BODY_SIZE) - t.rootCount;
  const shift = above < 0 ? f64x2.splat(0) : valueOf(placeAt(t, above));
  const closed = minus(shift, closing(t, rigid, at, k, part));
  if (at.below != 0) return setValue(at, closed);
  const root = rootOf(t, at);
  setMomentumBelow(root, minus(momentumBelow(root), closed));
  root.gw += 1;
}

// The part of its gap that a torn hinge closes, from the parent to the child.
function closing(t: JointTable, rigid: RigidTable, at: JointPlace, k: i32, part: f64): v128 {
  if (at.hinge == 0) return f64x2.splat(0);
  const p = stateOf(rigid, at.parentRow);
  const c = stateOf(rigid, at.childRow);
  const start = startAt(t, k);
  const between = plus(startBetween(start), minus(movementOf(c), movementOf(p)));
  const arms = minus(turnedBy(turnOf(c), startOfChild(start)), turnedBy(turnOf(p), startOfParent(start)));
  const gap = plus(between, arms);
  const square = dot2(gap, gap);
  if (!(square > TORN) || !isFree(t, treeOfRow(t, at.parentRow))) return f64x2.splat(0);
  return times(min<f64>(part, MOST_ERROR / sqrt<f64>(square)), gap);
}

// Of a tree that nothing holds the sum of mass times shift, and less than 0 the mass.
function weighShift(t: JointTable, at: JointPlace): void {
  const root = rootOf(t, at);
  if (at.below == 0 || root.gw > 0) return;
  if (root.gw == 0) root.gw = -root.mass;
  const mass = changetype<ArticulatedBody>(at.below).mass;
  setMomentumBelow(root, minus(momentumBelow(root), times(mass, valueOf(at))));
  root.gw -= mass;
}

// A body that is locked along an axis stays there.
function move(rigid: RigidTable, row: i32, shift: v128): void {
  const free = vector(inverseMassX(rigid, row) > 0 ? 1 : 0, inverseMassY(rigid, row) > 0 ? 1 : 0);
  const to = changetype<usize>(stateOf(rigid, row)) + offsetof<BodyState>('dx');
  storeReals(to, plus(loadReals(to), f64x2.mul(free, shift)));
}
