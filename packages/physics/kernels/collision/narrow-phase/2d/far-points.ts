// How far contacts see ahead: four slops, and further where bodies move further in a step, so that contacts stop them at the
// surface, together with joints and other contacts. What moves that far touches only what it meets within the step when it goes
// on as it does: or what passes a corner would be held up by it.
import { columns } from '../../../memory/columns';
import { LOCKED, flagsOf, poseOf, word } from '../../../solver/2d/body';
import { inverseMassAlong, openAxes } from '../../../solver/2d/motion-locks';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { Shape } from '../../shapes/2d/shape';
import { collideAhead, collideDiscsAhead, impactDistance, motionOf } from './collide-ahead';
import { Manifold, dropPoint } from './manifold';
import { foreseeWay, meetsFlat, passBy, slackOf } from './pass-by';
import { RigidContact, pointOf } from './rigid-contact';

// Shapes touch up to this distance, m: four times the slop of 5 mm.
export const SPECULATIVE_DISTANCE: real = 0.02;

// The distance up to which two shapes may touch: further than four slops if they move so far against each other.
export function reachOf(t: RigidTable, contact: RigidContact): real {
  if (canOnlyTurn(t, contact.bodyA, contact.a) || canOnlyTurn(t, contact.bodyB, contact.b)) return SPECULATIVE_DISTANCE;
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

// What is locked along an axis may have to turn at any speed to get out of the way in time, if it is no disc: it gives way softly instead.
function turnsOnLocks(t: RigidTable, body: i32, row: i32): bool {
  if ((flagsOf(t, body) & LOCKED) == 0 || !(poseOf(t, body).inverseInertia > 0)) return false;
  const isDisc = body == row && word(columns().shape, row) == 0;
  return !isDisc;
}

// Whether that is all that a body can do.
function canOnlyTurn(t: RigidTable, body: i32, row: i32): bool {
  return turnsOnLocks(t, body, row) && openAxes(t, body) == 0;
}

// Whether it is so along a normal.
function mustTurn(t: RigidTable, body: i32, row: i32, nx: real, ny: real): bool {
  if (!turnsOnLocks(t, body, row)) return false;
  return inverseMassAlong(t, body, nx, ny) < OPEN_PART * poseOf(t, body).inverseMass;
}

// Along a normal that gives a body this part of its inverse mass it is free enough: one at 45° to the axis that is not locked.
const OPEN_PART: real = 0.49;

// Finds the contact of two discs that are apart and come nearer. Returns false where it is that of now.
// @ts-ignore: decorator
@inline export function foreseeDiscs(
  t: RigidTable,
  contact: RigidContact,
  m: Manifold,
  shapeA: Shape,
  shapeB: Shape,
): bool {
  return collideDiscsAhead(t, contact, m, shapeA, shapeB, m.speculative == SPECULATIVE_DISTANCE);
}

// Leaves out what does not touch in this step, and the point that is further away than it may come. Returns whether nothing is left
// because of how fast the two are.
export function dropFarPoints(t: RigidTable, contact: RigidContact, m: Manifold, shapeA: Shape, shapeB: Shape): bool {
  if (m.count > 0 && m.speculative > SPECULATIVE_DISTANCE && mustGiveWay(t, contact, m)) keepNear(m);
  const isFast = m.speculative > SPECULATIVE_DISTANCE;
  if (m.count == 0) return isFast;
  const near = m.count == 2 ? min<real>(m.separation0, m.separation1) : m.separation0;
  if (isFast || near > 0) {
    const target = impactDistance(t, contact);
    const along = foreseeWay(t, contact, m.nx, m.ny);
    // What slides on a surface stays outside of it all the way, and yet rests on it.
    const maySlide = near + along > -slackOf(target) && (!isFast || near <= target);
    const mayPass = !maySlide && !meetsFlat(m, target);
    if (mayPass && passBy(t, contact, m, shapeA, shapeB, slackOf(target))) m.count = 0;
    else if (isFast && near > target) collideAhead(t, contact, m, shapeA, shapeB);
  }
  if (m.count == 2) dropFarPoint(t, contact, m);
  return m.count == 0;
}

// @ts-ignore: decorator
@inline function mustGiveWay(t: RigidTable, contact: RigidContact, m: Manifold): bool {
  return mustTurn(t, contact.bodyA, contact.a, m.nx, m.ny) || mustTurn(t, contact.bodyB, contact.b, m.nx, m.ny);
}

// Leaves out all points that are not near.
function keepNear(m: Manifold): void {
  if (m.count == 2 && m.separation1 > SPECULATIVE_DISTANCE) dropPoint(m, 1);
  if (m.separation0 > SPECULATIVE_DISTANCE) {
    if (m.count == 2) dropPoint(m, 0);
    else m.count = 0;
  }
  if (m.count > 0) m.speculative = SPECULATIVE_DISTANCE;
}

// Whether a manifold that is kept would stop bodies which are apart in this step: its normal may be another meanwhile.
export function mayStop(t: RigidTable, contact: RigidContact): bool {
  const first = pointOf(contact, 0).separation;
  const near = contact.count == 2 ? min<real>(first, pointOf(contact, 1).separation) : first;
  if (near <= 0) return false;
  return near + foreseeWay(t, contact, contact.nx, contact.ny) <= -slackOf(impactDistance(t, contact));
}

function dropFarPoint(t: RigidTable, contact: RigidContact, m: Manifold): void {
  const isSecondNear = m.separation1 < m.separation0;
  const gap = (isSecondNear ? m.separation0 : m.separation1) - SPECULATIVE_DISTANCE;
  if (gap <= 0) return;
  // What stops the near point pushes the far one by as much at most, if it does not bounce.
  const speed = max<real>(0, approach(t, contact, m, 0)) + max<real>(0, approach(t, contact, m, 1));
  if (gap > <real>t.dt * speed) dropPoint(m, isSecondNear ? 0 : 1);
}

// The speed at which the surfaces come nearer at a point, m/s.
function approach(t: RigidTable, contact: RigidContact, m: Manifold, i: i32): real {
  const x = i == 0 ? m.x0 : m.x1;
  const y = i == 0 ? m.y0 : m.y1;
  return speedAt(t, contact.bodyA, contact.a, m, x, y) - speedAt(t, contact.bodyB, contact.a, m, x, y);
}

// The speed of a body along the normal at a point that is given from the centre of the shape in row `origin`.
function speedAt(t: RigidTable, body: i32, origin: i32, m: Manifold, x: real, y: real): real {
  const state = motionOf(t, body);
  const armX = x + (poseOf(t, origin).x - poseOf(t, body).x);
  const armY = y + (poseOf(t, origin).y - poseOf(t, body).y);
  return m.nx * (state.vx - state.w * armY) + m.ny * (state.vy + state.w * armX);
}
