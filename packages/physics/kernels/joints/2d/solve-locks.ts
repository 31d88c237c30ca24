// The locked directions of joints. Those of a tree are solved exactly and at once, however long a chain and however heavy
// its end is: with the Jacobian J and the masses M, the impulses λ of all joints of the tree satisfy
//
//   (J M⁻¹ Jᵀ) y = J v + r C        Δλ = -q y - p λ             r, q, p: bias rate, mass and impulse scale (softness.ts)
//
// From the ends of a tree towards its root, each joint adds to the mass of its parent what hangs below it, seen through the
// joint; from the root back each joint gets its impulse: as many operations as there are joints. A joint that closes a loop
// follows by itself. The joint is softer than rigid by a millionth, so that what is held from two sides has a solution.
// Sources: Baraff, Linear-Time Dynamics using Lagrange Multipliers (SIGGRAPH 1996); Featherstone, Rigid Body Dynamics
// Algorithms (2008), chapter 7.
import { word } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { ArticulatedBody, accelerate, articulated, invert } from './articulated-body';
import { exertHinge, factorHinge, gatherHinge } from './hinge-locks';
import { JointTable, impulsesOf } from './joint-table';
import { JointRow, JointWork, childOf, isHinge, parentOf, rowOf, workAt } from './joint-work';
import { applyLocks, coupling, finite, speedAlong, stateA, stateB } from './joint-rows';
import { softenJoint } from './soft-impulse';
import { watchJoint } from './watch-joints';

const COMPLIANCE: f64 = 1e-6;

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
function factorJoint(t: JointTable, work: JointWork): void {
  const share = work.parent == 0 ? 1 : COMPLIANCE;
  if (isHinge(work)) return factorHinge(t, work, share);
  const child = childOf(work);
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  work.i00 = share * coupling(work, r0, r0);
  work.i01 = share * coupling(work, r0, r1);
  work.i02 = share * coupling(work, r0, r2);
  work.i11 = share * coupling(work, r1, r1);
  work.i12 = share * coupling(work, r1, r2);
  work.i22 = share * coupling(work, r2, r2);
  if (child != 0) {
    const body = articulated(t, child);
    invert(changetype<usize>(body));
    addThrough(body, work, r0, r1, r2);
  }
  // A row of zeros has no impulse, whatever its element is.
  if (work.locks < 3) work.i22 = 1;
  if (work.locks < 2) work.i11 = 1;
  if (work.locks < 1) work.i00 = 1;
  invert(changetype<usize>(work) + offsetof<JointWork>('i00'));
  if (work.parent != 0) addToParent(articulated(t, parentOf(work)), work, r0, r1, r2);
}

// Adds J W Jᵀ for the inverse mass matrix W of the child.
// @ts-ignore: decorator
@inline function addThrough(w: ArticulatedBody, work: JointWork, r0: JointRow, r1: JointRow, r2: JointRow): void {
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
@inline function addToParent(to: ArticulatedBody, work: JointWork, r0: JointRow, r1: JointRow, r2: JointRow): void {
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

// With `soft`, joints pull together what is apart, and their matrices are made for the rows as they are measured now;
// without it, this sub-step ends, and the largest forces are kept.
export function solveLocks(table: usize, soft: i32): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  softenJoint(rigid);
  const bias = soft != 0 ? softness.biasRate : 0;
  if (soft == 0) {
    softness.massScale = 1;
    softness.impulseScale = 0;
  }
  for (let k = t.workCount - 1; k >= 0; k--) {
    const work = workAt(t, k);
    if (soft != 0) factorJoint(t, work);
    gatherForces(t, rigid, work, bias);
  }
  for (let k = 0; k < t.rootCount; k++) {
    const root = articulated(t, word(t.roots, k));
    if (soft != 0) invert(changetype<usize>(root));
    accelerate(root);
  }
  for (let k = 0; k < t.workCount; k++) {
    const work = workAt(t, k);
    exert(t, rigid, work, bias);
    if (soft == 0) watchJoint(t, work);
  }
}

// How much a row would move with what a body does, as part of v_b - v_a.
// @ts-ignore: decorator
@inline function motion(body: ArticulatedBody, row: JointRow, arm: f64): f64 {
  return row.x * body.fx + row.y * body.fy + arm * body.fw;
}

// From the ends: what is left for the parent to do.
function gatherForces(t: JointTable, rigid: RigidTable, work: JointWork, bias: f64): void {
  if (work.parent == 0 || work.locks == 0) return;
  if (isHinge(work)) return gatherHinge(t, rigid, work, bias);
  const sign: f64 = work.parent == 1 ? 1 : -1;
  const child = childOf(work);
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  r0.value = speedAlong(a, b, r0) + bias * r0.error;
  r1.value = speedAlong(a, b, r1) + bias * r1.error;
  r2.value = speedAlong(a, b, r2) + bias * r2.error;
  if (child != 0) {
    const body = articulated(t, child);
    accelerate(body);
    r0.value -= sign * motion(body, r0, childArm(work, r0));
    r1.value -= sign * motion(body, r1, childArm(work, r1));
    r2.value -= sign * motion(body, r2, childArm(work, r2));
  }
  const y0 = sign * (work.i00 * r0.value + work.i01 * r1.value + work.i02 * r2.value);
  const y1 = sign * (work.i01 * r0.value + work.i11 * r1.value + work.i12 * r2.value);
  const y2 = sign * (work.i02 * r0.value + work.i12 * r1.value + work.i22 * r2.value);
  const to = articulated(t, parentOf(work));
  to.gx -= y0 * r0.x + y1 * r1.x + y2 * r2.x;
  to.gy -= y0 * r0.y + y1 * r1.y + y2 * r2.y;
  to.gw -= y0 * parentArm(work, r0) + y1 * parentArm(work, r1) + y2 * parentArm(work, r2);
}

// From the root: the impulses of a joint, and what the child does with them.
function exert(t: JointTable, rigid: RigidTable, work: JointWork, bias: f64): void {
  if (work.locks == 0) return;
  if (isHinge(work)) return exertHinge(t, rigid, work, bias);
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  let v0 = r0.value;
  let v1 = r1.value;
  let v2 = r2.value;
  const sign: f64 = work.parent == 1 ? 1 : -1;
  if (work.parent == 0) {
    v0 = speedAlong(a, b, r0) + bias * r0.error;
    v1 = speedAlong(a, b, r1) + bias * r1.error;
    v2 = speedAlong(a, b, r2) + bias * r2.error;
  } else {
    const from = articulated(t, parentOf(work));
    v0 += sign * motion(from, r0, parentArm(work, r0));
    v1 += sign * motion(from, r1, parentArm(work, r1));
    v2 += sign * motion(from, r2, parentArm(work, r2));
  }
  const y0 = work.i00 * v0 + work.i01 * v1 + work.i02 * v2;
  const y1 = work.i01 * v0 + work.i11 * v1 + work.i12 * v2;
  const y2 = work.i02 * v0 + work.i12 * v1 + work.i22 * v2;
  const child = childOf(work);
  if (child != 0) push(articulated(t, child), work, sign * y0, sign * y1, sign * y2);
  const impulses = impulsesOf(t, work.id);
  const j0 = finite(-softness.massScale * y0 - softness.impulseScale * impulses.lock0);
  const j1 = finite(-softness.massScale * y1 - softness.impulseScale * impulses.lock1);
  const j2 = finite(-softness.massScale * y2 - softness.impulseScale * impulses.lock2);
  impulses.lock0 += j0;
  impulses.lock1 += j1;
  impulses.lock2 += j2;
  applyLocks(work, a, b, j0, j1, j2);
}

// Adds W Jᵀ y to the motion of the child.
// @ts-ignore: decorator
@inline function push(body: ArticulatedBody, work: JointWork, y0: f64, y1: f64, y2: f64): void {
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  const x = y0 * r0.x + y1 * r1.x + y2 * r2.x;
  const y = y0 * r0.y + y1 * r1.y + y2 * r2.y;
  const w = y0 * childArm(work, r0) + y1 * childArm(work, r1) + y2 * childArm(work, r2);
  body.fx += body.m00 * x + body.m01 * y + body.m02 * w;
  body.fy += body.m01 * x + body.m11 * y + body.m12 * w;
  body.fw += body.m02 * x + body.m12 * y + body.m22 * w;
}
