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
import { ArticulatedBody, articulated, invert, startBody } from './articulated-body';
import { braceJoints } from './brace-joints';
import { JointTable, impulsesOf } from './joint-table';
import { JointRow, JointWork, nodeA, nodeB, rowOf, workAt } from './joint-work';
import { applyAlong, coupling, finite, speedAlong, stateA, stateB } from './joint-rows';
import { softenJoint } from './soft-impulse';

const COMPLIANCE: f64 = 1e-6;

// Prepares the solution for the rows as they are measured now.
export function factorJoints(table: usize): void {
  const t = changetype<JointTable>(table);
  braceJoints(t);
  for (let i = 0; i < t.workCount; i++) {
    const work = workAt(t, i);
    if (work.massA > 0) startBody(t, work.a, work.massA, work.inertiaA);
    if (work.massB > 0) startBody(t, work.b, work.massB, work.inertiaB);
  }
  for (let k = t.workCount - 1; k >= 0; k--) factorJoint(t, workAt(t, k));
  for (let k = 0; k < t.rootCount; k++) invert(changetype<usize>(articulated(t, word(t.roots, k))));
}

// @ts-ignore: decorator
@inline function childOf(work: JointWork): i32 {
  return work.parent == 1 ? nodeB(work) : nodeA(work);
}

// @ts-ignore: decorator
@inline function parentOf(work: JointWork): i32 {
  return work.parent == 1 ? nodeA(work) : nodeB(work);
}

// Arms and sign of a row at the parent and at the child.
// @ts-ignore: decorator
@inline function parentArm(work: JointWork, row: JointRow): f64 {
  return work.parent == 1 ? row.armA : row.armB;
}

// @ts-ignore: decorator
@inline function childArm(work: JointWork, row: JointRow): f64 {
  return work.parent == 1 ? row.armB : row.armA;
}

function factorJoint(t: JointTable, work: JointWork): void {
  const child = work.parent == 0 ? 0 : childOf(work);
  const body = articulated(t, child);
  if (child != 0) invert(changetype<usize>(body));
  const matrix = changetype<usize>(work) + offsetof<JointWork>('i00');
  let at = matrix;
  for (let p = 0; p < 3; p++) {
    for (let q = p; q < 3; q++) {
      let value: f64 = p == q ? 1 : 0;
      if (q < work.locks) {
        const own = coupling(work, rowOf(work, p), rowOf(work, q));
        value = work.parent == 0 ? own : COMPLIANCE * own;
        if (child != 0) value += through(body, work, rowOf(work, p), rowOf(work, q));
      }
      store<f64>(at, value);
      at += 8;
    }
  }
  invert(matrix);
  if (work.parent != 0) addToParent(t, work);
}

// J W Jᵀ for two rows and the inverse mass matrix W of the child.
// @ts-ignore: decorator
@inline function through(w: ArticulatedBody, work: JointWork, p: JointRow, q: JointRow): f64 {
  const arm = childArm(work, q);
  const x = w.m00 * q.x + w.m01 * q.y + w.m02 * arm;
  const y = w.m01 * q.x + w.m11 * q.y + w.m12 * arm;
  const z = w.m02 * q.x + w.m12 * q.y + w.m22 * arm;
  return p.x * x + p.y * y + childArm(work, p) * z;
}

// The element (p, q) of the inverse effective mass matrix.
// @ts-ignore: decorator
@inline function inverseAt(work: JointWork, p: i32, q: i32): f64 {
  const i = min<i32>(p, q);
  const j = max<i32>(p, q);
  const index = (i == 0 ? 0 : 2 * i + 1) + j - i;
  return load<f64>(changetype<usize>(work) + offsetof<JointWork>('i00') + ((<usize>index) << 3));
}

function addToParent(t: JointTable, work: JointWork): void {
  const to = articulated(t, parentOf(work));
  for (let p = 0; p < work.locks; p++) {
    for (let q = 0; q < work.locks; q++) {
      const k = inverseAt(work, p, q);
      const a = rowOf(work, p);
      const b = rowOf(work, q);
      const armA = parentArm(work, a);
      const armB = parentArm(work, b);
      to.m00 += k * a.x * b.x;
      to.m01 += k * a.x * b.y;
      to.m02 += k * a.x * armB;
      to.m11 += k * a.y * b.y;
      to.m12 += k * a.y * armB;
      to.m22 += k * armA * armB;
    }
  }
}

// With `soft`, joints pull together what is apart.
export function solveLocks(table: usize, soft: i32): void {
  const t = changetype<JointTable>(table);
  const rigid = changetype<RigidTable>(t.rigid);
  softenJoint(rigid);
  const bias = soft != 0 ? softness.biasRate : 0;
  for (let i = 0; i < t.workCount; i++) clearForces(t, workAt(t, i));
  for (let k = t.workCount - 1; k >= 0; k--) gatherForces(t, rigid, workAt(t, k), bias);
  for (let k = 0; k < t.rootCount; k++) accelerate(articulated(t, word(t.roots, k)));
  for (let k = 0; k < t.workCount; k++) exert(t, rigid, workAt(t, k), bias, soft != 0);
}

// @ts-ignore: decorator
@inline function clearForces(t: JointTable, work: JointWork): void {
  clearForce(articulated(t, work.a));
  clearForce(articulated(t, work.b));
}

// @ts-ignore: decorator
@inline function clearForce(body: ArticulatedBody): void {
  body.fx = 0;
  body.fy = 0;
  body.fw = 0;
}

// f becomes W f.
// @ts-ignore: decorator
@inline function accelerate(body: ArticulatedBody): void {
  const x = body.fx;
  const y = body.fy;
  const w = body.fw;
  body.fx = body.m00 * x + body.m01 * y + body.m02 * w;
  body.fy = body.m01 * x + body.m11 * y + body.m12 * w;
  body.fw = body.m02 * x + body.m12 * y + body.m22 * w;
}

// How much a row would move with what a body does, as part of v_b - v_a.
// @ts-ignore: decorator
@inline function motion(body: ArticulatedBody, row: JointRow, arm: f64, sign: f64): f64 {
  return sign * (row.x * body.fx + row.y * body.fy + arm * body.fw);
}

// From the ends: what is left for the parent to do.
function gatherForces(t: JointTable, rigid: RigidTable, work: JointWork, bias: f64): void {
  if (work.parent == 0) return;
  const sign: f64 = work.parent == 1 ? 1 : -1;
  const child = childOf(work);
  const body = articulated(t, child);
  if (child != 0) accelerate(body);
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  for (let p = 0; p < work.locks; p++) {
    const row = rowOf(work, p);
    row.value = speedAlong(a, b, row) + bias * row.error;
    if (child != 0) row.value -= motion(body, row, childArm(work, row), sign);
  }
  const to = articulated(t, parentOf(work));
  for (let p = 0; p < work.locks; p++) {
    const row = rowOf(work, p);
    const impulse = -sign * wantedImpulse(work, p);
    to.fx += impulse * row.x;
    to.fy += impulse * row.y;
    to.fw += impulse * parentArm(work, row);
  }
}

// @ts-ignore: decorator
@inline function wantedImpulse(work: JointWork, p: i32): f64 {
  let sum: f64 = 0;
  for (let q = 0; q < work.locks; q++) sum += inverseAt(work, p, q) * rowOf(work, q).value;
  return sum;
}

// From the root: the impulses of a joint, and what the child does with them.
function exert(t: JointTable, rigid: RigidTable, work: JointWork, bias: f64, soft: bool): void {
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  const sign: f64 = work.parent == 1 ? 1 : -1;
  const child = work.parent == 0 ? 0 : childOf(work);
  const from = articulated(t, work.parent == 0 ? 0 : parentOf(work));
  for (let p = 0; p < work.locks; p++) {
    const row = rowOf(work, p);
    if (work.parent == 0) row.value = speedAlong(a, b, row) + bias * row.error;
    else row.value += motion(from, row, parentArm(work, row), sign);
  }
  const massScale = soft ? softness.massScale : 1;
  const impulseScale = soft ? softness.impulseScale : 0;
  const kept = changetype<usize>(impulsesOf(t, work.id));
  for (let p = 0; p < work.locks; p++) {
    const row = rowOf(work, p);
    const y = wantedImpulse(work, p);
    if (child != 0) push(articulated(t, child), work, row, sign * y);
    const slot = kept + ((<usize>p) << 3);
    const impulse = finite(-massScale * y - impulseScale * load<f64>(slot));
    store<f64>(slot, load<f64>(slot) + impulse);
    applyAlong(work, a, b, row, impulse);
  }
}

// Adds W Jᵀ y to the motion of the child.
// @ts-ignore: decorator
@inline function push(body: ArticulatedBody, work: JointWork, row: JointRow, y: f64): void {
  const x = y * row.x;
  const z = y * row.y;
  const w = y * childArm(work, row);
  body.fx += body.m00 * x + body.m01 * z + body.m02 * w;
  body.fy += body.m01 * x + body.m11 * z + body.m12 * w;
  body.fw += body.m02 * x + body.m12 * z + body.m22 * w;
}
