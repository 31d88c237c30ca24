// The two locked directions of a hinge, x and y of its point: what solve-locks.ts does for any three rows, without the
// products by 0 and 1. Most joints are hinges; these are the inner loops of chains, bridges and ragdolls.
//
// With the arm r of a body, its point moves by v + ω × r: the arm of the row x is -r_y, that of the row y is r_x.
import { BodyState } from '../../solver/2d/body';
import { RigidTable } from '../../solver/2d/rigid-table';
import { softness } from '../../solver/2d/softness';
import { ArticulatedBody, accelerate, articulated, invert } from './articulated-body';
import { JointTable } from './joint-table';
import { JointWork, childOf, parentOf } from './joint-work';
import { finite, stateA, stateB } from './joint-rows';

// Arms at the parent and at the child, as the rows x and y have them.
// @ts-ignore: decorator
@inline function parentX(work: JointWork): f64 {
  return work.parent == 1 ? -work.ray : -work.rby;
}

// @ts-ignore: decorator
@inline function parentY(work: JointWork): f64 {
  return work.parent == 1 ? work.rax : work.rbx;
}

// @ts-ignore: decorator
@inline function childX(work: JointWork): f64 {
  return work.parent == 1 ? -work.rby : -work.ray;
}

// @ts-ignore: decorator
@inline function childY(work: JointWork): f64 {
  return work.parent == 1 ? work.rbx : work.rax;
}

export function factorHinge(t: JointTable, work: JointWork, share: f64): void {
  const mass = work.massA + work.massB;
  let xx = share * (mass + work.inertiaA * work.ray * work.ray + work.inertiaB * work.rby * work.rby);
  let xy = -share * (work.inertiaA * work.rax * work.ray + work.inertiaB * work.rbx * work.rby);
  let yy = share * (mass + work.inertiaA * work.rax * work.rax + work.inertiaB * work.rbx * work.rbx);
  const child = childOf(work);
  if (child != 0) {
    const w = articulated(t, child);
    invert(changetype<usize>(w));
    const cx = childX(work);
    const cy = childY(work);
    xx += w.m00 + cx * (w.m02 + w.m02 + cx * w.m22);
    xy += w.m01 + cx * w.m12 + cy * (w.m02 + cx * w.m22);
    yy += w.m11 + cy * (w.m12 + w.m12 + cy * w.m22);
  }
  const determinant = xx * yy - xy * xy;
  const k = determinant != 0 ? 1 / determinant : 0;
  work.i00 = yy * k;
  work.i01 = -xy * k;
  work.i11 = xx * k;
  if (work.parent != 0) addToParent(articulated(t, parentOf(work)), work);
}

// @ts-ignore: decorator
@inline function addToParent(to: ArticulatedBody, work: JointWork): void {
  const px = parentX(work);
  const py = parentY(work);
  const x = work.i00 * px + work.i01 * py;
  const y = work.i01 * px + work.i11 * py;
  to.m00 += work.i00;
  to.m01 += work.i01;
  to.m11 += work.i11;
  to.m02 += x;
  to.m12 += y;
  to.m22 += px * x + py * y;
}

// @ts-ignore: decorator
@inline function speedX(work: JointWork, a: BodyState, b: BodyState): f64 {
  return <f64>b.vx - <f64>a.vx - work.rby * <f64>b.w + work.ray * <f64>a.w;
}

// @ts-ignore: decorator
@inline function speedY(work: JointWork, a: BodyState, b: BodyState): f64 {
  return <f64>b.vy - <f64>a.vy + work.rbx * <f64>b.w - work.rax * <f64>a.w;
}

export function gatherHinge(t: JointTable, rigid: RigidTable, work: JointWork, bias: f64): void {
  const sign: f64 = work.parent == 1 ? 1 : -1;
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  let vx = speedX(work, a, b) + bias * work.dx;
  let vy = speedY(work, a, b) + bias * work.dy;
  const child = childOf(work);
  if (child != 0) {
    const body = articulated(t, child);
    accelerate(body);
    vx -= sign * (body.fx + childX(work) * body.fw);
    vy -= sign * (body.fy + childY(work) * body.fw);
  }
  work.valueX = vx;
  work.valueY = vy;
  const x = sign * (work.i00 * vx + work.i01 * vy);
  const y = sign * (work.i01 * vx + work.i11 * vy);
  const to = articulated(t, parentOf(work));
  to.gx -= x;
  to.gy -= y;
  to.gw -= parentX(work) * x + parentY(work) * y;
}

export function exertHinge(t: JointTable, rigid: RigidTable, work: JointWork, bias: f64): void {
  const a = stateA(rigid, work);
  const b = stateB(rigid, work);
  const sign: f64 = work.parent == 1 ? 1 : -1;
  let vx = work.valueX;
  let vy = work.valueY;
  if (work.parent == 0) {
    vx = speedX(work, a, b) + bias * work.dx;
    vy = speedY(work, a, b) + bias * work.dy;
  } else {
    const from = articulated(t, parentOf(work));
    vx += sign * (from.fx + parentX(work) * from.fw);
    vy += sign * (from.fy + parentY(work) * from.fw);
  }
  const x = work.i00 * vx + work.i01 * vy;
  const y = work.i01 * vx + work.i11 * vy;
  const child = childOf(work);
  if (child != 0) push(articulated(t, child), work, sign * x, sign * y);
  const jx = finite(-softness.massScale * x - softness.impulseScale * work.impulseX);
  const jy = finite(-softness.massScale * y - softness.impulseScale * work.impulseY);
  work.impulseX += jx;
  work.impulseY += jy;
  applyAtHinge(work, a, b, jx, jy);
}

// @ts-ignore: decorator
@inline function push(body: ArticulatedBody, work: JointWork, x: f64, y: f64): void {
  const w = childX(work) * x + childY(work) * y;
  body.fx += body.m00 * x + body.m01 * y + body.m02 * w;
  body.fy += body.m01 * x + body.m11 * y + body.m12 * w;
  body.fw += body.m02 * x + body.m12 * y + body.m22 * w;
}

// Applies an impulse to b at the hinge, and its opposite to a.
// @ts-ignore: decorator
@inline export function applyAtHinge(work: JointWork, a: BodyState, b: BodyState, x: f64, y: f64): void {
  a.vx = <real>(<f64>a.vx - work.massA * x);
  a.vy = <real>(<f64>a.vy - work.massA * y);
  a.w = <real>(<f64>a.w - work.inertiaA * (work.rax * y - work.ray * x));
  b.vx = <real>(<f64>b.vx + work.massB * x);
  b.vy = <real>(<f64>b.vy + work.massB * y);
  b.w = <real>(<f64>b.w + work.inertiaB * (work.rbx * y - work.rby * x));
}
