// The locked directions of a joint in a tree that is solved by rows: all that are no plain hinges (hinge-locks.ts). The formulas are
// in solve-locks.ts.
import { stateOf } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { ArticulatedBody, ArticulatedMass, addOwnMass, freeVelocity, invert, massBeside } from './articulated-body';
import { follow } from './hinge-locks';
import { JointTable } from './joint-table';
import { LOOP } from './joint-trees';
import { JointPlace, JointRow, JointWork, placeAt, rowOf, signOf, workAt } from './joint-work';
import { coupling } from './joint-rows';
import { COMPLIANCE } from './soft-impulse';

// Arms of a row at the parent and at the child.
// @ts-ignore: decorator
@inline function parentArm(work: JointWork, row: JointRow): f64 {
  return work.parent == 1 ? row.armA : row.armB;
}

// @ts-ignore: decorator
@inline function childArm(work: JointWork, row: JointRow): f64 {
  return work.parent == 1 ? row.armB : row.armA;
}

// What a unit impulse along one row changes along another, as if locked axes gave way a little.
// @ts-ignore: decorator
@inline export function couplingOnRails(work: JointWork, p: JointRow, q: JointRow): f64 {
  return coupling(work, p, q) + work.railX * (p.x * q.x) + work.railY * (p.y * q.y);
}

// The rows of a joint with fewer locked directions are zero, so three are solved of every joint: without loops, that is
// faster than two or one.
export function factorJoint(t: JointTable, at: JointPlace, work: JointWork): void {
  const compliance = at.below == 0 ? COMPLIANCE : softness.compliance;
  const share = work.parent == LOOP ? 1 : compliance;
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  work.i00 = share * couplingOnRails(work, r0, r0);
  work.i01 = share * couplingOnRails(work, r0, r1);
  work.i02 = share * couplingOnRails(work, r0, r2);
  work.i11 = share * couplingOnRails(work, r1, r1);
  work.i12 = share * couplingOnRails(work, r1, r2);
  work.i22 = share * couplingOnRails(work, r2, r2);
  giveWay(work);
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

// Where one of the directions is a spring, it is as soft as that, and no softer.
// @ts-ignore: decorator
@inline function giveWay(work: JointWork): void {
  if (work.springLock == 2) work.i22 = max<f64>(work.i22, work.give);
  else if (work.springLock == 1) work.i11 = max<f64>(work.i11, work.give);
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
  load(changetype<ArticulatedBody>(at.above), work);
}

// Adds to the momentum of the parent what the rows of a joint pass on.
// @ts-ignore: decorator
@inline function load(to: ArticulatedBody, work: JointWork): void {
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  const y0 = work.i00 * r0.value + work.i01 * r1.value + work.i02 * r2.value;
  const y1 = work.i01 * r0.value + work.i11 * r1.value + work.i12 * r2.value;
  const y2 = work.i02 * r0.value + work.i12 * r1.value + work.i22 * r2.value;
  to.gx += y0 * r0.x + y1 * r1.x + y2 * r2.x;
  to.gy += y0 * r0.y + y1 * r1.y + y2 * r2.y;
  to.gw += y0 * parentArm(work, r0) + y1 * parentArm(work, r1) + y2 * parentArm(work, r2);
}

// Turns the values of the rows into the impulses along them, on the parent, and gives the child its velocity.
export function passJoint(t: JointTable, rigid: RigidTable, k: i32): void {
  const at = placeAt(t, k);
  pullChild(t, at, workAt(t, k));
  if (at.below != 0) follow(stateOf(rigid, at.childRow), changetype<ArticulatedBody>(at.below), at.turns != 0);
}

// The same for the velocity in the tree alone, which the state of the child does not follow.
export function pullChild(t: JointTable, at: JointPlace, work: JointWork): void {
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
}

// The same as `gatherJoint` for a tree at rest, on whose bodies impulses act.
export function gatherResponse(t: JointTable, at: JointPlace, work: JointWork): void {
  const r0 = rowOf(work, 0);
  const r1 = rowOf(work, 1);
  const r2 = rowOf(work, 2);
  r0.value = 0;
  r1.value = 0;
  r2.value = 0;
  if (at.below == 0) return;
  const body = changetype<ArticulatedBody>(at.below);
  freeVelocity(body, massBeside(t, at.below), 0, 0, 0);
  r0.value = motion(body, r0, childArm(work, r0));
  r1.value = motion(body, r1, childArm(work, r1));
  r2.value = motion(body, r2, childArm(work, r2));
  load(changetype<ArticulatedBody>(at.above), work);
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
