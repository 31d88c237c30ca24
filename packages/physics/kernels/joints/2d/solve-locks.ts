// The locked directions of joints. Those of a tree are solved exactly and at once, however long a chain and however heavy
// its end is: with the Jacobian J, the masses M and velocities v that no joint of the tree has changed in this sub-step, the
// velocities v* with the least (v* - v)ᵀ M (v* - v) for which
//
//   J v* = -r C - c       v += q (v* - v)        λ = q M (v* - v)            r, q: bias rate and mass scale (softness.ts)
//
// From the ends of a tree towards its root, each joint adds to the mass and the momentum of its parent what hangs below it,
// seen through the joint; from the root back each body gets its velocity: as many operations as there are joints. What the
// joints exerted before does not matter: it would be taken back. Where few joints close loops, these are solved with their tree
// (close-loops.ts). In nets each follows by itself: Δλ = -q y - p λ with (J M⁻¹ Jᵀ) y = J v + r C and the impulse scale
// p = 1 - q. The joint is a little softer than rigid, so that what is held from two sides has a solution (soft-impulse.ts).
// Sources: Baraff, Linear-Time Dynamics using Lagrange Multipliers (SIGGRAPH 1996); Featherstone, Rigid Body Dynamics
// Algorithms (2008), chapter 7.
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { notePull } from './brace-rods';
import { closeAllLoops } from './close-loops';
import { engageLimit, predictLimits, releaseLimits, settleLimit, takeBackLimits } from './engage-limits';
import { engageMotor, exchangeMotors, predictMotor, settleMotor, takeBackMotor } from './engage-motors';
import { engageSpring, settleSpring } from './engage-springs';
import { exertHinge, gatherHinge, measureHinge, watchHinge } from './hinge-locks';
import { DISTANCE, JointTable, impulsesOf } from './joint-table';
import { LOOP } from './joint-trees';
import { JointPlace, PLAIN, placeAt, rowOf, signOf, startAt, workAt } from './joint-work';
import { applyLocks, finite, speedAlong, stateA, stateB } from './joint-rows';
import { bearSpring, pushAxes } from './push-axes';
import { factorJoint, gatherJoint, passJoint } from './row-locks';
import { softenJoint } from './soft-impulse';
import { relaxLoops, solveLoops } from './solve-loops';
import { applyImpulses, clearMasses } from './start-joints';
import { factorRoots, moveRoot } from './sweep-tree';
import { watchJoint } from './watch-joints';

// Joints pull together what is apart, and their matrices are made for the rows as they are measured now.
export function solveLocks(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  softenJoint(rigid);
  if (t.otherCount > 0) engageAll(t, rigid);
  solveAll(t, rigid, softness.biasRate, true, true);
  solveLoops(t);
}

// Which limits bear and which motors hold in this sub-step. What joints exerted in the last one is known before, and taken back.
function engageAll(t: JointTable, rigid: RigidTable): void {
  for (let k = 0; k < t.closedCount; k++) {
    predictLimits(t, rigid, k);
    predictMotor(t, rigid, k);
  }
  for (let k = 0; k < t.closedCount; k++) {
    if (placeAt(t, k).hinge == PLAIN) continue;
    applyImpulses(t, rigid, k, -1);
    takeBackLimits(t, rigid, k);
    takeBackMotor(t, rigid, k);
    bearSpring(t, rigid, k);
  }
  for (let k = 0; k < t.closedCount; k++) {
    engageLimit(t, rigid, k);
    engageMotor(t, rigid, k);
    engageSpring(t, rigid, workAt(t, k));
  }
}

// Takes back the speed at which joints pulled, and ends the sub-step: the largest forces are kept.
export function relaxLocks(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  softenJoint(rigid);
  let others = t.otherCount > 0 && releaseLimits(t, rigid);
  if (t.otherCount > 0 && exchangeMotors(t, rigid)) others = true;
  if (others) clearMasses(t, rigid);
  softness.massScale = 1;
  softness.impulseScale = 0;
  solveAll(t, rigid, 0, false, others);
  relaxLoops(t);
}

// One function for both, because a branch on `soft` costs less than the code would weigh twice. With `factor` matrices are made.
export function solveAll(t: JointTable, rigid: RigidTable, bias: f64, soft: bool, factor: bool): void {
  for (let k = 0; t.otherCount > 0 && k < t.closedCount; k++) if (placeAt(t, k).hinge != PLAIN) pushAxes(t, k);
  for (let k = t.treeCount - 1; k >= 0; k--) {
    const at = placeAt(t, k);
    if (soft && at.hinge == PLAIN) measureHinge(t, rigid, at, startAt(t, k));
    if (at.hinge != 0) gatherHinge(t, rigid, at, startAt(t, k), soft, factor);
    else gatherJoint(t, rigid, k, bias, factor);
  }
  if (factor) factorRoots(t);
  if (t.mechanismCount > 0) closeAllLoops(t, rigid, bias, soft, factor);
  for (let k = 0; k < t.rootCount; k++) moveRoot(t, rigid, k);
  for (let k = 0; k < t.treeCount; k++) {
    const at = placeAt(t, k);
    if (at.hinge != 0) exertHinge(rigid, at, startAt(t, k), soft);
    else exertJoint(t, rigid, k, soft);
    if (!soft) watch(t, at, k);
  }
  for (let k = t.treeCount; k < t.workCount; k++) {
    const at = placeAt(t, k);
    if (at.parent == LOOP) {
      if (soft) factorJoint(t, at, workAt(t, k));
      exertLoop(t, rigid, k, bias);
    }
    if (!soft) watch(t, at, k);
  }
}

// @ts-ignore: decorator
@inline function watch(t: JointTable, at: JointPlace, k: i32): void {
  if (at.hinge == PLAIN) return watchHinge(at);
  settleLimit(t, workAt(t, k));
  settleMotor(t, workAt(t, k));
  settleSpring(t, workAt(t, k));
  watchJoint(t, k);
}

// From the root: the impulses of a joint, and the velocity of the child.
function exertJoint(t: JointTable, rigid: RigidTable, k: i32, soft: bool): void {
  passJoint(t, rigid, k);
  const work = workAt(t, k);
  const impulses = impulsesOf(t, work.id);
  const scale = -signOf(placeAt(t, k)) * softness.massScale;
  const pull = impulses.lock1;
  impulses.lock0 = (soft ? 0 : impulses.lock0) + finite(scale * rowOf(work, 0).value);
  impulses.lock1 = (soft ? 0 : impulses.lock1) + finite(scale * rowOf(work, 1).value);
  impulses.lock2 = (soft ? 0 : impulses.lock2) + finite(scale * rowOf(work, 2).value);
  if (soft && work.kind == DISTANCE) notePull(impulses, pull);
}

// A joint that closes a loop, and belongs to no mechanism.
function exertLoop(t: JointTable, rigid: RigidTable, k: i32, bias: f64): void {
  const work = workAt(t, k);
  if (work.locks == 0) return;
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  const rate = bias * work.reach;
  const v0 = speedAlong(a, b, r0) + rate * r0.error + r0.chord;
  const v1 = speedAlong(a, b, r1) + rate * r1.error + r1.chord;
  const v2 = speedAlong(a, b, r2) + rate * r2.error + r2.chord;
  const impulses = impulsesOf(t, work.id);
  const massScale = softness.massScale;
  const impulseScale = softness.impulseScale;
  const y0 = work.i00 * v0 + work.i01 * v1 + work.i02 * v2;
  const y1 = work.i01 * v0 + work.i11 * v1 + work.i12 * v2;
  const y2 = work.i02 * v0 + work.i12 * v1 + work.i22 * v2;
  const j0 = finite(-massScale * y0 - impulseScale * impulses.lock0);
  const j1 = finite(-massScale * y1 - impulseScale * impulses.lock1);
  const j2 = finite(-massScale * y2 - impulseScale * impulses.lock2);
  impulses.lock0 += j0;
  impulses.lock1 += j1;
  impulses.lock2 += j2;
  applyLocks(work, a, b, j0, j1, j2);
}
