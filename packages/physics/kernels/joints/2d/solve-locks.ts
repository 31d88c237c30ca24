// The locked directions of joints. Those of a tree are solved exactly and at once, however long a chain and however heavy
// its end is: with the Jacobian J, the masses M and velocities v that no joint of the tree has changed in this sub-step, the
// velocities v* with the least (v* - v)ᵀ M (v* - v) for which
//
//   J v* = -r C - c       v += q (v* - v)        λ = q M (v* - v)            r, q: bias rate and mass scale (softness.ts)
//
// From the ends of a tree towards its root, each joint adds to the mass and the momentum of its parent what hangs below it,
// seen through the joint; from the root back each body gets its velocity: as many operations as there are joints. What the
// joints exerted before does not matter: it would be taken back. A joint that closes a loop follows by itself: Δλ = -q y - p λ
// with (J M⁻¹ Jᵀ) y = J v + r C and the impulse scale p = 1 - q. The joint is a little softer than rigid, so that
// what is held from two sides has a solution (hinge-locks.ts).
// Sources: Baraff, Linear-Time Dynamics using Lagrange Multipliers (SIGGRAPH 1996); Featherstone, Rigid Body Dynamics
// Algorithms (2008), chapter 7.
import { stateOf, word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import {
  ArticulatedBody,
  ArticulatedMass,
  addOwnMass,
  articulated,
  freeVelocity,
  invert,
  massBeside,
  massOf,
} from './articulated-body';
import { jointed } from './brace-joints';
import { notePull } from './brace-rods';
import { engageLimit, predictLimits, releaseLimits, settleLimit, takeBackLimits } from './engage-limits';
import { exertHinge, follow, gatherHinge, measureHinge, watchHinge } from './hinge-locks';
import { DISTANCE, JointTable, impulsesOf } from './joint-table';
import { JointPlace, JointRow, JointWork, PLAIN, placeAt, rowOf, signOf, startAt, workAt } from './joint-work';
import { applyLocks, coupling, finite, speedAlong, stateA, stateB } from './joint-rows';
import { COMPLIANCE, softenJoint } from './soft-impulse';
import { relaxLoops, solveLoops } from './solve-loops';
import { applyImpulses, clearMasses } from './start-joints';
import { watchJoint } from './watch-joints';

// Arms of a row at the parent and at the child.
// @ts-ignore: decorator
@inline function parentArm(work: JointWork, row: JointRow): f64 {
  return work.parent == 1 ? row.armA : row.armB;
}

// @ts-ignore: decorator
@inline function childArm(work: JointWork, row: JointRow): f64 {
  return work.parent == 1 ? row.armB : row.armA;
}

// The rows of a joint with fewer locked directions are zero, so three are solved of every joint: without loops, that is
// faster than two or one.
function factorJoint(t: JointTable, at: JointPlace, work: JointWork): void {
  const share = work.parent == 0 ? 1 : at.below == 0 ? COMPLIANCE : softness.compliance;
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  work.i00 = share * coupling(work, r0, r0);
  work.i01 = share * coupling(work, r0, r1);
  work.i02 = share * coupling(work, r0, r2);
  work.i11 = share * coupling(work, r1, r1);
  work.i12 = share * coupling(work, r1, r2);
  work.i22 = share * coupling(work, r2, r2);
  if (at.below != 0) {
    const mass = massBeside(t, at.below);
    addOwnMass(mass, changetype<ArticulatedBody>(at.below));
    invert(changetype<usize>(mass));
    addThrough(mass, work, r0, r1, r2);
  }
  // A row of zeros has no impulse, whatever its element is. That across a rod (brace-rods.ts) gives way as its mass does.
  if (work.locks < 3) work.i22 = work.acrossInverse > 0 ? work.i22 + work.acrossInverse : 1;
  if (work.locks < 2) work.i11 = 1;
  if (work.locks < 1) work.i00 = 1;
  invert(changetype<usize>(work) + offsetof<JointWork>('i00'));
  if (at.above != 0) addToParent(massBeside(t, at.above), work, r0, r1, r2);
}

// Adds J W Jᵀ for the inverse mass matrix W of the child.
// @ts-ignore: decorator
@inline function addThrough(w: ArticulatedMass, work: JointWork, r0: JointRow, r1: JointRow, r2: JointRow): void {
  const c0 = childArm(work, r0);
  const c1 = childArm(work, r1);
  const c2 = childArm(work, r2);
  const x0 = w.m00 * r0.x + w.m01 * r0.y + w.m02 * c0;
  const y0 = w.m01 * r0.x + w.m11 * r0.y + w.m12 * c0;
  const z0 = w.m02 * r0.x + w.m12 * r0.y + w.m22 * c0;
  work.i00 += r0.x * x0 + r0.y * y0 + c0 * z0;
  work.i01 += r1.x * x0 + r1.y * y0 + c1 * z0;
  work.i02 += r2.x * x0 + r2.y * y0 + c2 * z0;
  const x1 = w.m00 * r1.x + w.m01 * r1.y + w.m02 * c1;
  const y1 = w.m01 * r1.x + w.m11 * r1.y + w.m12 * c1;
  const z1 = w.m02 * r1.x + w.m12 * r1.y + w.m22 * c1;
  work.i11 += r1.x * x1 + r1.y * y1 + c1 * z1;
  work.i12 += r2.x * x1 + r2.y * y1 + c2 * z1;
  const x2 = w.m00 * r2.x + w.m01 * r2.y + w.m02 * c2;
  const y2 = w.m01 * r2.x + w.m11 * r2.y + w.m12 * c2;
  const z2 = w.m02 * r2.x + w.m12 * r2.y + w.m22 * c2;
  work.i22 += r2.x * x2 + r2.y * y2 + c2 * z2;
}

// Adds Jᵀ K J for the effective mass matrix K of the joint: what hangs below it, as the parent feels it.
// @ts-ignore: decorator
@inline function addToParent(to: ArticulatedMass, work: JointWork, r0: JointRow, r1: JointRow, r2: JointRow): void {
  const p0 = parentArm(work, r0);
  const p1 = parentArm(work, r1);
  const p2 = parentArm(work, r2);
  const x0 = work.i00 * r0.x + work.i01 * r1.x + work.i02 * r2.x;
  const x1 = work.i01 * r0.x + work.i11 * r1.x + work.i12 * r2.x;
  const x2 = work.i02 * r0.x + work.i12 * r1.x + work.i22 * r2.x;
  to.m00 += r0.x * x0 + r1.x * x1 + r2.x * x2;
  const y0 = work.i00 * r0.y + work.i01 * r1.y + work.i02 * r2.y;
  const y1 = work.i01 * r0.y + work.i11 * r1.y + work.i12 * r2.y;
  const y2 = work.i02 * r0.y + work.i12 * r1.y + work.i22 * r2.y;
  to.m01 += r0.x * y0 + r1.x * y1 + r2.x * y2;
  to.m11 += r0.y * y0 + r1.y * y1 + r2.y * y2;
  const w0 = work.i00 * p0 + work.i01 * p1 + work.i02 * p2;
  const w1 = work.i01 * p0 + work.i11 * p1 + work.i12 * p2;
  const w2 = work.i02 * p0 + work.i12 * p1 + work.i22 * p2;
  to.m02 += r0.x * w0 + r1.x * w1 + r2.x * w2;
  to.m12 += r0.y * w0 + r1.y * w1 + r2.y * w2;
  to.m22 += p0 * w0 + p1 * w1 + p2 * w2;
}

// Joints pull together what is apart, and their matrices are made for the rows as they are measured now.
export function solveLocks(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  softenJoint(rigid);
  for (let k = 0; t.otherCount > 0 && k < t.treeCount; k++) predictLimits(t, rigid, k);
  for (let k = 0; t.otherCount > 0 && k < t.treeCount; k++) {
    if (placeAt(t, k).hinge == PLAIN) continue;
    applyImpulses(t, rigid, k, -1);
    takeBackLimits(t, rigid, k);
  }
  for (let k = 0; t.otherCount > 0 && k < t.treeCount; k++) engageLimit(t, rigid, k);
  solveAll(t, rigid, softness.biasRate, true, true);
  solveLoops(t);
}

// Takes back the speed at which joints pulled, and ends the sub-step: the largest forces are kept.
export function relaxLocks(table: usize): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  const others = t.otherCount > 0 && releaseLimits(t, rigid);
  if (others) clearMasses(t, rigid);
  softness.massScale = 1;
  softness.impulseScale = 0;
  solveAll(t, rigid, 0, false, others);
  relaxLoops(t);
}

// One function for both, because a branch on `soft` costs less than the code would weigh twice. With `factor` matrices are made.
export function solveAll(t: JointTable, rigid: RigidTable, bias: f64, soft: bool, factor: bool): void {
  for (let k = t.treeCount - 1; k >= 0; k--) {
    const at = placeAt(t, k);
    if (soft && at.hinge == PLAIN) measureHinge(rigid, at, startAt(t, k));
    if (at.hinge != 0) gatherHinge(t, rigid, at, startAt(t, k), soft, factor);
    else gatherJoint(t, rigid, k, bias, factor);
  }
  moveRoots(t, rigid, factor);
  for (let k = 0; k < t.treeCount; k++) {
    const at = placeAt(t, k);
    if (at.hinge != 0) exertHinge(rigid, at, startAt(t, k), soft);
    else exertJoint(t, rigid, k, soft);
    if (!soft) watch(t, at, k);
  }
  for (let k = t.treeCount; k < t.workCount; k++) {
    const at = placeAt(t, k);
    if (soft) factorJoint(t, at, workAt(t, k));
    exertLoop(t, rigid, k, bias);
    if (!soft) watch(t, at, k);
  }
}

// @ts-ignore: decorator
@inline function watch(t: JointTable, at: JointPlace, k: i32): void {
  if (at.hinge == PLAIN) return watchHinge(at);
  settleLimit(t, workAt(t, k));
  watchJoint(t, k);
}

function moveRoots(t: JointTable, rigid: RigidTable, factor: bool): void {
  for (let k = 0; k < t.rootCount; k++) moveRoot(t, rigid, k, factor);
}

export function moveRoot(t: JointTable, rigid: RigidTable, k: i32, factor: bool): void {
  const root = articulated(t, k);
  const mass = massOf(t, k);
  const row = word(t.roots, k);
  const state = stateOf(rigid, row);
  if (factor) addOwnMass(mass, root);
  if (factor) invert(changetype<usize>(mass));
  freeVelocity(root, mass, <f64>state.vx, <f64>state.vy, <f64>state.w);
  follow(state, root, jointed(t, row).inverseInertia > 0);
}

// How much a row moves with the velocity of a body.
// @ts-ignore: decorator
@inline function motion(body: ArticulatedBody, row: JointRow, arm: f64): f64 {
  return row.x * body.vx + row.y * body.vy + arm * body.w;
}

// From the ends: what the parent bears.
export function gatherJoint(t: JointTable, rigid: RigidTable, k: i32, bias: f64, factor: bool): void {
  const at = placeAt(t, k);
  const work = workAt(t, k);
  if (factor) factorJoint(t, at, work);
  const state = stateOf(rigid, at.childRow);
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  const sign = signOf(at);
  const rate = bias * work.reach;
  r0.value = sign * (rate * r0.error + r0.chord);
  r1.value = sign * (rate * r1.error + r1.chord);
  r2.value = sign * (rate * r2.error + r2.chord);
  const vx = <f64>state.vx;
  const vy = <f64>state.vy;
  const w = <f64>state.w;
  if (at.below != 0) {
    const body = changetype<ArticulatedBody>(at.below);
    freeVelocity(body, massBeside(t, at.below), vx, vy, w);
    r0.value += motion(body, r0, childArm(work, r0));
    r1.value += motion(body, r1, childArm(work, r1));
    r2.value += motion(body, r2, childArm(work, r2));
  } else {
    r0.value += r0.x * vx + r0.y * vy + childArm(work, r0) * w;
    r1.value += r1.x * vx + r1.y * vy + childArm(work, r1) * w;
    r2.value += r2.x * vx + r2.y * vy + childArm(work, r2) * w;
  }
  const y0 = work.i00 * r0.value + work.i01 * r1.value + work.i02 * r2.value;
  const y1 = work.i01 * r0.value + work.i11 * r1.value + work.i12 * r2.value;
  const y2 = work.i02 * r0.value + work.i12 * r1.value + work.i22 * r2.value;
  const to = changetype<ArticulatedBody>(at.above);
  to.gx += y0 * r0.x + y1 * r1.x + y2 * r2.x;
  to.gy += y0 * r0.y + y1 * r1.y + y2 * r2.y;
  to.gw += y0 * parentArm(work, r0) + y1 * parentArm(work, r1) + y2 * parentArm(work, r2);
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

// Turns the values of the rows into the impulses along them, on the parent, and gives the child its velocity.
export function passJoint(t: JointTable, rigid: RigidTable, k: i32): void {
  const at = placeAt(t, k);
  const work = workAt(t, k);
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  const from = changetype<ArticulatedBody>(at.above);
  const v0 = r0.value - motion(from, r0, parentArm(work, r0));
  const v1 = r1.value - motion(from, r1, parentArm(work, r1));
  const v2 = r2.value - motion(from, r2, parentArm(work, r2));
  r0.value = work.i00 * v0 + work.i01 * v1 + work.i02 * v2;
  r1.value = work.i01 * v0 + work.i11 * v1 + work.i12 * v2;
  r2.value = work.i02 * v0 + work.i12 * v1 + work.i22 * v2;
  if (at.below == 0) return;
  const body = changetype<ArticulatedBody>(at.below);
  pull(body, massBeside(t, at.below), work, -r0.value, -r1.value, -r2.value);
  follow(stateOf(rigid, at.childRow), body, at.turns != 0);
}

// Adds W Jᵀ y to the velocity of the child.
// @ts-ignore: decorator
@inline function pull(
  body: ArticulatedBody,
  mass: ArticulatedMass,
  work: JointWork,
  y0: f64,
  y1: f64,
  y2: f64,
): void {
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  const x = y0 * r0.x + y1 * r1.x + y2 * r2.x;
  const y = y0 * r0.y + y1 * r1.y + y2 * r2.y;
  const w = y0 * childArm(work, r0) + y1 * childArm(work, r1) + y2 * childArm(work, r2);
  body.vx += mass.m00 * x + mass.m01 * y + mass.m02 * w;
  body.vy += mass.m01 * x + mass.m11 * y + mass.m12 * w;
  body.w += mass.m02 * x + mass.m12 * y + mass.m22 * w;
}

// A joint that closes a loop.
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
