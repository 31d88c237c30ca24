// How far contacts see ahead. Shapes touch when they are nearer than four slops; then the other end of the edge counts as far
// away as it may come in this step, or the end of a plank that falls over would sink in before it is a contact. What joints hold
// touches as far away as that, too: contacts and joints then stop it together. Put back alone by continuous collision, it would
// tear the joints.
import { ASLEEP, JOINED, MOVES, flagsOf, poseOf, stateOf } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { Manifold, dropPoint } from './manifold';
import { RigidContact } from './rigid-contact';

// Shapes touch up to this distance, m: four times the slop of 5 mm.
export const SPECULATIVE_DISTANCE: real = 0.02;

// The distance up to which two shapes may touch.
export function reachOf(t: RigidTable, contact: RigidContact): real {
  const flags = flagsOf(t, contact.bodyA) | flagsOf(t, contact.bodyB);
  if ((flags & JOINED) == 0) return SPECULATIVE_DISTANCE;
  return SPECULATIVE_DISTANCE + <real>t.dt * (fastest(t, contact.bodyA) + fastest(t, contact.bodyB));
}

// The highest speed of a point of a body, m/s.
function fastest(t: RigidTable, body: i32): real {
  if (!isMoving(t, body)) return 0;
  const state = stateOf(t, body);
  return sqrt<real>(state.vx * state.vx + state.vy * state.vy) + abs<real>(state.w) * poseOf(t, body).extent;
}

// @ts-ignore: decorator
@inline function isMoving(t: RigidTable, body: i32): bool {
  return (flagsOf(t, body) & MOVES) != 0 && (flagsOf(t, body) & ASLEEP) == 0;
}

// Leaves out the points that are further away than they may come in this step.
export function dropFarPoints(t: RigidTable, contact: RigidContact, m: Manifold): void {
  if (m.count == 0) return;
  const isSecondNear = m.count == 2 && m.separation1 < m.separation0;
  const near = isSecondNear ? m.separation1 : m.separation0;
  const far = m.count == 1 ? near : isSecondNear ? m.separation0 : m.separation1;
  if (far <= SPECULATIVE_DISTANCE) return;
  const ahead = <real>t.dt * max<real>(0, approach(t, contact, m, isSecondNear ? 1 : 0));
  if (near > SPECULATIVE_DISTANCE + ahead) {
    m.count = 0;
    return;
  }
  if (m.count == 1) return;
  // What stops the near point pushes the far one by as much at most, if it does not bounce.
  const reach = ahead + <real>t.dt * max<real>(0, approach(t, contact, m, isSecondNear ? 0 : 1));
  if (far > SPECULATIVE_DISTANCE + reach) dropPoint(m, isSecondNear ? 0 : 1);
}

// The speed at which the surfaces come nearer at a point, m/s.
function approach(t: RigidTable, contact: RigidContact, m: Manifold, i: i32): real {
  const x = i == 0 ? m.x0 : m.x1;
  const y = i == 0 ? m.y0 : m.y1;
  return speedAt(t, contact.bodyA, contact.a, m, x, y) - speedAt(t, contact.bodyB, contact.a, m, x, y);
}

// The speed of a body along the normal at a point that is given from the centre of the shape in row `from`.
function speedAt(t: RigidTable, body: i32, from: i32, m: Manifold, x: real, y: real): real {
  if (!isMoving(t, body)) return 0;
  const state = stateOf(t, body);
  const armX = x + (poseOf(t, from).x - poseOf(t, body).x);
  const armY = y + (poseOf(t, from).y - poseOf(t, body).y);
  return m.nx * (state.vx - state.w * armY) + m.ny * (state.vy + state.w * armX);
}
