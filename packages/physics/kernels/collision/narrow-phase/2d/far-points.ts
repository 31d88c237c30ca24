// How far contacts see ahead: four slops, and further where bodies move further in a step, so that contacts stop them at the
// surface, together with joints and other contacts. What moves that far touches only what it meets within the step when it goes
// on as it does: or what passes a corner would be held up by it.
import { ASLEEP, BodyState, LOCKED, MOVES, flagsOf, poseOf, stateOf } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { Shape } from '../../shapes/2d/shape';
import { Manifold, dropPoint } from './manifold';
import { RigidContact } from './rigid-contact';
import { Sweep, timeOfImpact } from './time-of-impact';

// Shapes touch up to this distance, m: four times the slop of 5 mm.
export const SPECULATIVE_DISTANCE: real = 0.02;
// The distance at which a time of impact counts, m: the slop, so that a body that is put there has a contact.
export const TARGET: real = 0.005;

const sweep = changetype<Sweep>(memory.data(offsetof<Sweep>() + 8, 8));

// The distance up to which two shapes may touch: further than four slops if they move so far against each other. What is locked
// along an axis may have to turn at any speed to get out of the way in time: it gives way softly instead.
export function reachOf(t: RigidTable, contact: RigidContact): real {
  if (((flagsOf(t, contact.bodyA) | flagsOf(t, contact.bodyB)) & LOCKED) != 0) return SPECULATIVE_DISTANCE;
  const stateA = motionOf(t, contact.bodyA);
  const stateB = motionOf(t, contact.bodyB);
  const a = poseOf(t, contact.bodyA);
  const b = poseOf(t, contact.bodyB);
  // The velocity of the larger at the centre of the smaller, against the velocity of that, and how fast they turn.
  const x = b.x - a.x;
  const y = b.y - a.y;
  const w = a.extent < b.extent ? stateB.w : stateA.w;
  const vx = stateB.vx - stateA.vx + w * y;
  const vy = stateB.vy - stateA.vy - w * x;
  const turn = abs<real>(stateB.w - stateA.w) * min<real>(a.extent, b.extent);
  const path = <real>t.dt * (sqrt<real>(vx * vx + vy * vy) + turn);
  return path > SPECULATIVE_DISTANCE ? SPECULATIVE_DISTANCE + path : SPECULATIVE_DISTANCE;
}

// The velocities of a body: those of the world, row 0, if it does not move.
// @ts-ignore: decorator
@inline function motionOf(t: RigidTable, body: i32): BodyState {
  return stateOf(t, isMoving(t, body) ? body : 0);
}

// @ts-ignore: decorator
@inline function isMoving(t: RigidTable, body: i32): bool {
  return (flagsOf(t, body) & MOVES) != 0 && (flagsOf(t, body) & ASLEEP) == 0;
}

// Leaves out the points that are further away than they may come in this step.
export function dropFarPoints(t: RigidTable, contact: RigidContact, m: Manifold, shapeA: Shape, shapeB: Shape): void {
  if (m.count == 0) return;
  const isSecondNear = m.count == 2 && m.separation1 < m.separation0;
  const near = isSecondNear ? m.separation1 : m.separation0;
  if (near > TARGET && m.speculative > SPECULATIVE_DISTANCE && !meet(t, contact, shapeA, shapeB)) {
    m.count = 0;
    return;
  }
  if (m.count == 1) return;
  const gap = (isSecondNear ? m.separation0 : m.separation1) - SPECULATIVE_DISTANCE;
  if (gap <= 0) return;
  // What stops the near point pushes the far one by as much at most, if it does not bounce.
  const speed = max<real>(0, approach(t, contact, m, 0)) + max<real>(0, approach(t, contact, m, 1));
  if (gap > <real>t.dt * speed) dropPoint(m, isSecondNear ? 0 : 1);
}

// Whether two shapes meet in this step if their bodies go on as they are.
function meet(t: RigidTable, contact: RigidContact, shapeA: Shape, shapeB: Shape): bool {
  foresee(t, contact.bodyA, contact.a, contact.a);
  sweep.ax = start.x;
  sweep.ay = start.y;
  sweep.ac = start.c;
  sweep.as = start.s;
  sweep.endAx = end.x;
  sweep.endAy = end.y;
  sweep.endAc = end.c;
  sweep.endAs = end.s;
  foresee(t, contact.bodyB, contact.b, contact.a);
  sweep.bx = start.x;
  sweep.by = start.y;
  sweep.bc = start.c;
  sweep.bs = start.s;
  sweep.endBx = end.x;
  sweep.endBy = end.y;
  sweep.endBc = end.c;
  sweep.endBs = end.s;
  sweep.target = TARGET;
  timeOfImpact(sweep, shapeA, shapeB);
  return sweep.isHit != 0;
}

@unmanaged
class Place {
  x: real;
  y: real;
  c: real;
  s: real;
}

const start = changetype<Place>(memory.data(offsetof<Place>() + 8, 8));
const end = changetype<Place>(memory.data(offsetof<Place>() + 8, 8));

// The pose of a shape now, from that of the shape `origin`, and at the end of the step.
function foresee(t: RigidTable, body: i32, row: i32, origin: i32): void {
  const pose = poseOf(t, row);
  start.x = pose.x - poseOf(t, origin).x;
  start.y = pose.y - poseOf(t, origin).y;
  end.x = start.x;
  end.y = start.y;
  end.c = start.c = pose.c;
  end.s = start.s = pose.s;
  if (!isMoving(t, body)) return;
  const state = stateOf(t, body);
  const dt = <real>t.dt;
  // To second order, and of length 1 again: less than half a turn.
  const half = <real>0.5 * max<real>(-2, min<real>(2, dt * state.w));
  const scale = <real>1 / (1 + half * half);
  const c = (<real>1 - half * half) * scale;
  const s = <real>2 * half * scale;
  const armX = pose.x - poseOf(t, body).x;
  const armY = pose.y - poseOf(t, body).y;
  end.x += dt * state.vx + (c * armX - s * armY) - armX;
  end.y += dt * state.vy + (s * armX + c * armY) - armY;
  end.c = pose.c * c - pose.s * s;
  end.s = pose.s * c + pose.c * s;
}

// The speed at which the surfaces come nearer at a point, m/s.
function approach(t: RigidTable, contact: RigidContact, m: Manifold, i: i32): real {
  const x = i == 0 ? m.x0 : m.x1;
  const y = i == 0 ? m.y0 : m.y1;
  return speedAt(t, contact.bodyA, contact.a, m, x, y) - speedAt(t, contact.bodyB, contact.a, m, x, y);
}

// The speed of a body along the normal at a point that is given from the centre of the shape in row `from`.
function speedAt(t: RigidTable, body: i32, origin: i32, m: Manifold, x: real, y: real): real {
  const state = motionOf(t, body);
  const armX = x + (poseOf(t, origin).x - poseOf(t, body).x);
  const armY = y + (poseOf(t, origin).y - poseOf(t, body).y);
  return m.nx * (state.vx - state.w * armY) + m.ny * (state.vy + state.w * armX);
}
