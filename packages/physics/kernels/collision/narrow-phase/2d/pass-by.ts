// Whether two outlines pass each other in a step without touching: where one of them has an edge that the other stays outside of all
// the way. A box that falls into a slot as wide as itself does so, and must not be held up by the corners of the slot, which are
// straight below its own until it has passed them.
//
//   distance + min(0, n · u) ≥ turning       of an edge with the normal n, as the other outline moves by u
import { BodyState, poseOf } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { Shape, normalX, normalY } from '../../shapes/2d/shape';
import { motionOf } from './collide-ahead';
import { Manifold } from './manifold';
import { RelativePose, invert, poseOfB } from './relative-pose';
import { RigidContact } from './rigid-contact';
import { distanceFromEdge } from './separating-axis';

// What overlaps by this part of the distance of an impact at most may pass: room for rounding, 10 µm. Boxes with restitution that
// passed with more would overlap after the step, and gain energy.
const SLACK_PART: real = 0.002;

const bInA = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));
const aInB = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

// The manifold is that of now, its nearest point is `near` away, and an impact counts at the distance `target`.
export function passBy(
  t: RigidTable,
  contact: RigidContact,
  m: Manifold,
  a: Shape,
  b: Shape,
  near: real,
  target: real,
): bool {
  if (a.count < 2 || b.count < 2 || (a.isChained | b.isChained) != 0) return false;
  const stateA = motionOf(t, contact.bodyA);
  const stateB = motionOf(t, contact.bodyB);
  const dt = <real>t.dt;
  // How the centre of b moves beside that of a.
  const x = dt * (velocityX(t, stateB, contact.bodyB, contact.b) - velocityX(t, stateA, contact.bodyA, contact.a));
  const y = dt * (velocityY(t, stateB, contact.bodyB, contact.b) - velocityY(t, stateA, contact.bodyA, contact.a));
  const slack = SLACK_PART * target;
  // What slides on a surface stays outside of it all the way, and yet rests on it.
  if (near <= target && near + m.nx * x + m.ny * y > -slack) return false;
  const turning = dt * (abs<real>(stateA.w) * a.extent + abs<real>(stateB.w) * b.extent);
  const limit = a.radius + b.radius + turning - slack;
  poseOfB(bInA, m);
  if (staysOutside(a, b, bInA, m.ac * x + m.as * y, m.ac * y - m.as * x, limit)) return true;
  invert(aInB, bInA);
  return staysOutside(b, a, aInB, -(m.bc * x + m.bs * y), m.bs * x - m.bc * y, limit);
}

// The velocity of the centre of a shape, which is in row `row`.
// @ts-ignore: decorator
@inline function velocityX(t: RigidTable, state: BodyState, body: i32, row: i32): real {
  return state.vx - state.w * (poseOf(t, row).y - poseOf(t, body).y);
}

// @ts-ignore: decorator
@inline function velocityY(t: RigidTable, state: BodyState, body: i32, row: i32): real {
  return state.vy + state.w * (poseOf(t, row).x - poseOf(t, body).x);
}

// Whether `second`, whose pose in the frame of `first` is given, stays outside of one edge as it moves by (x, y).
function staysOutside(first: Shape, second: Shape, pose: RelativePose, x: real, y: real, limit: real): bool {
  for (let i = 0; i < first.count; i++) {
    const along = normalX(first, i) * x + normalY(first, i) * y;
    if (distanceFromEdge(first, i, second, pose) + min<real>(0, along) >= limit) return true;
  }
  return false;
}
