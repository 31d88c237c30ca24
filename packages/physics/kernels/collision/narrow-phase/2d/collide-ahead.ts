// The contact of two shapes that fly, as it will be when they meet, if they do so within the step: normal and anchors are those of
// the impact, and the separations say how far away it is. So what turns, or passes close by, is hit where and as it would be
// in short steps.
import { ASLEEP, BodyState, MOVES, WALL, flagsOf, poseOf, stateOf } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { PLANE, Shape } from '../../shapes/2d/shape';
import { collideShapes } from './collide-shapes';
import { Manifold, setPoses } from './manifold';
import { FORESEEN, RigidContact, pointOf } from './rigid-contact';
import { ShapeMotion, motionOfA, motionOfB, move, stay } from './shape-motion';
import { Sweep, timeOfImpact } from './time-of-impact';

// The distance at which a time of impact counts, m: the slop, so that a body that is put there has a contact.
export const TARGET: real = 0.005;

// At most this part of the least extent, so that what is small is not stopped far from the impact, where the normal is another. In f32
// less than the least distance would be lost in rounding.
const TARGET_PART: real = 0.025;
export const LEAST_TARGET: real = 0.0001;

// The distance at which a time of impact counts for a body with this least extent, m.
// @ts-ignore: decorator
@inline export function targetOf(minExtent: real): real {
  return max<real>(LEAST_TARGET, min<real>(TARGET, TARGET_PART * minExtent));
}

// Whether the shapes of a contact are two discs.
// @ts-ignore: decorator
@inline export function areDiscs(t: RigidTable, contact: RigidContact): bool {
  return (contact.shapeA | contact.shapeB) == 0 && ((flagsOf(t, contact.a) | flagsOf(t, contact.b)) & WALL) == 0;
}

// As `targetOf`, for two shapes: the smaller of those that move counts. Of two discs the normal is known at any distance.
export function impactDistance(t: RigidTable, contact: RigidContact): real {
  if (areDiscs(t, contact)) return LEAST_TARGET;
  const a = isMoving(t, contact.bodyA) ? poseOf(t, contact.a).minExtent : <real>Infinity;
  const b = isMoving(t, contact.bodyB) ? poseOf(t, contact.b).minExtent : <real>Infinity;
  return targetOf(min<real>(a, b));
}

const sweep = changetype<Sweep>(memory.data(offsetof<Sweep>() + 8, 8));

// The velocities of a body: those of the world, row 0, if it does not move.
// @ts-ignore: decorator
@inline export function motionOf(t: RigidTable, body: i32): BodyState {
  return stateOf(t, isMoving(t, body) ? body : 0);
}

// @ts-ignore: decorator
@inline function isMoving(t: RigidTable, body: i32): bool {
  return (flagsOf(t, body) & MOVES) != 0 && (flagsOf(t, body) & ASLEEP) == 0;
}

// Leaves no point where the two do not meet.
export function collideAhead(t: RigidTable, contact: RigidContact, m: Manifold, shapeA: Shape, shapeB: Shape): void {
  if (!meet(t, contact, shapeA, shapeB)) {
    m.count = 0;
    return;
  }
  if (sweep.fraction == 0) return;
  collideAt(sweep.fraction, m, shapeA, shapeB);
  contact.flags |= FORESEEN;
  // The solver follows the movements from the start of the step on, and turns the anchors as if they were those then.
  const time = sweep.fraction * <real>t.dt;
  m.separation0 += time * turning(t, contact, m, m.x0, m.y0);
  m.separation1 += time * turning(t, contact, m, m.x1, m.y1);
}

// The same for two discs d apart, of which one moves by u in the step from the other. They meet at a fraction f of it, at any speed:
//
//   |d + f u| = R
//
// Slow ones that do not meet, but would come through the plane between them as they are now, have the contact of the end of
// the step: this plane they do not reach. Returns false where the contact is that of now.
export function collideDiscsAhead(
  t: RigidTable,
  contact: RigidContact,
  m: Manifold,
  shapeA: Shape,
  shapeB: Shape,
  isSlow: bool,
): bool {
  const radii = shapeA.radius + shapeB.radius;
  const distance = sqrt<real>(m.bx * m.bx + m.by * m.by);
  const gap = distance - radii;
  if (gap <= LEAST_TARGET || gap > m.speculative) return false;
  // What pushed the two apart in the last step is the contact of now, as in heaps.
  if (contact.count > 0 && pointOf(contact, 0).normalImpulse > 0) return false;
  foreseeBoth(t, contact, motionOfA(sweep), motionOfB(sweep));
  const x = sweep.endBx - sweep.endAx - (sweep.bx - sweep.ax);
  const y = sweep.endBy - sweep.endAy - (sweep.by - sweep.ay);
  const along = -(m.bx * x + m.by * y);
  // The last sub-step ends by stopping what would meet in another one.
  const end: real = isSlow ? <real>(1 + t.h / t.dt) : 1;
  if (isSlow && end * along <= distance * (gap - LEAST_TARGET)) return false;
  const apart = (gap - LEAST_TARGET) * (distance + radii + LEAST_TARGET);
  const square = along * along - (x * x + y * y) * apart;
  const meeting = along > 0 && square >= 0 ? apart / (along + sqrt<real>(square)) : <real>Infinity;
  const fraction = min<real>(end, meeting);
  collideAt(fraction, m, shapeA, shapeB);
  if (meeting > end && !isSlow) m.count = 0;
  contact.flags |= FORESEEN;
  m.separation0 += fraction * <real>t.dt * turning(t, contact, m, m.x0, m.y0);
  return true;
}

// Whether two shapes meet in this step if their bodies go on as they are; then `sweep` says when.
function meet(t: RigidTable, contact: RigidContact, shapeA: Shape, shapeB: Shape): bool {
  sweep.target = impactDistance(t, contact);
  if (shapeB.kind == PLANE) {
    // A half-plane may only be the first of two outlines (distance.ts).
    foreseeBoth(t, contact, motionOfB(sweep), motionOfA(sweep));
    timeOfImpact(sweep, shapeB, shapeA);
  }
  foreseeBoth(t, contact, motionOfA(sweep), motionOfB(sweep));
  if (shapeB.kind != PLANE) timeOfImpact(sweep, shapeA, shapeB);
  return sweep.isHit != 0;
}

function foreseeBoth(t: RigidTable, contact: RigidContact, a: ShapeMotion, b: ShapeMotion): void {
  foresee(t, contact.bodyA, contact.a, contact.a, a);
  foresee(t, contact.bodyB, contact.b, contact.a, b);
}

// Finds the contact at the fraction of the step at which the two meet.
function collideAt(f: real, m: Manifold, shapeA: Shape, shapeB: Shape): void {
  const ac = sweep.ac + f * (sweep.endAc - sweep.ac);
  const as = sweep.as + f * (sweep.endAs - sweep.as);
  const bc = sweep.bc + f * (sweep.endBc - sweep.bc);
  const bs = sweep.bs + f * (sweep.endBs - sweep.bs);
  const a = <real>1 / sqrt<real>(ac * ac + as * as);
  const b = <real>1 / sqrt<real>(bc * bc + bs * bs);
  const x = sweep.bx - sweep.ax;
  const y = sweep.by - sweep.ay;
  setPoses(
    m,
    x + f * (sweep.endBx - sweep.endAx - x),
    y + f * (sweep.endBy - sweep.endAy - y),
    a * ac,
    a * as,
    b * bc,
    b * bs,
  );
  collideShapes(m, shapeA, shapeB);
}

// The speed at which the surfaces come nearer at a point because the shapes turn.
function turning(t: RigidTable, contact: RigidContact, m: Manifold, x: real, y: real): real {
  const wa = motionOf(t, contact.bodyA).w;
  const wb = motionOf(t, contact.bodyB).w;
  const bx = x - m.bx;
  const by = y - m.by;
  return m.nx * (wb * by - wa * y) + m.ny * (wa * x - wb * bx);
}

// The motion of a shape from now on, beside the shape `origin`.
function foresee(t: RigidTable, body: i32, row: i32, origin: i32, motion: ShapeMotion): void {
  const pose = poseOf(t, row);
  stay(motion, pose.x - poseOf(t, origin).x, pose.y - poseOf(t, origin).y, pose.c, pose.s);
  if (!isMoving(t, body)) return;
  const state = stateOf(t, body);
  const dt = <real>t.dt;
  // To second order, and of length 1 again: less than half a turn.
  const half = <real>0.5 * max<real>(-2, min<real>(2, dt * state.w));
  const scale = <real>1 / (1 + half * half);
  const c = (<real>1 - half * half) * scale;
  const s = <real>2 * half * scale;
  const centre = poseOf(t, body);
  move(motion, pose.x - centre.x, pose.y - centre.y, dt * state.vx, dt * state.vy, c, s);
}
