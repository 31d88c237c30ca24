// Whether two outlines pass each other in a step without touching: where a line is between them all the way, either along the way itself
// or along an edge of one of them. A box that falls into a slot as wide as itself does so, and must not be held up by the corners of the
// slot, which are straight below its own until it has passed them. A ball that flies closely past a corner does so, too.
//
//   distance + min(0, n · u) ≥ turning       along the normal n of the line, as the other outline moves by u
import { RigidTable } from '../../../solver/2d/rigid-table';
import { PLANE, Shape, normalX, normalY } from '../../shapes/2d/shape';
import { motionOf } from './collide-ahead';
import { Manifold } from './manifold';
import { RelativePose, invert, poseOfB } from './relative-pose';
import { RigidContact } from './rigid-contact';
import { distanceFromEdge, leastProjection } from './separating-axis';
import { velocityX, velocityY } from './shape-velocity';

// 10 µm for what is not small. Boxes with restitution that passed with more would overlap after the step, and gain energy.
const SLACK_PART: real = 0.002;

const bInA = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));
const aInB = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

// How the centre of b moves beside that of a in this step and one more sub-step: the last one ends by stopping what would meet then.
let wayX: real = 0;
let wayY: real = 0;

// Returns how far b moves along a normal: less than 0 if the two come nearer.
export function foreseeWay(t: RigidTable, contact: RigidContact, nx: real, ny: real): real {
  const a = motionOf(t, contact.bodyA);
  const b = motionOf(t, contact.bodyB);
  const time = <real>(t.dt + t.h);
  wayX = time * (velocityX(t, b, contact.bodyB, contact.b) - velocityX(t, a, contact.bodyA, contact.a));
  wayY = time * (velocityY(t, b, contact.bodyB, contact.b) - velocityY(t, a, contact.bodyA, contact.a));
  return nx * wayX + ny * wayY;
}

// Whether edges lie along each other by more than the two move beside each other, so that they cannot pass: tells most that meet, at once.
// After `foreseeWay`.
export function meetsFlat(m: Manifold, target: real): bool {
  if (m.count < 2) return false;
  const together = abs<real>(m.nx * (m.y1 - m.y0) - m.ny * (m.x1 - m.x0));
  return together > abs<real>(m.nx * wayY - m.ny * wayX) + target;
}

// Where an impact counts at the distance `target`, what overlaps by so much at most may pass: room for rounding.
// @ts-ignore: decorator
@inline export function slackOf(target: real): real {
  return SLACK_PART * target;
}

// The manifold is that of now. After `foreseeWay`.
export function passBy(t: RigidTable, contact: RigidContact, m: Manifold, a: Shape, b: Shape, slack: real): bool {
  if (a.kind == PLANE || b.kind == PLANE) return false;
  const wa = abs<real>(motionOf(t, contact.bodyA).w);
  const wb = abs<real>(motionOf(t, contact.bodyB).w);
  // What is round about its centre turns without moving its outline.
  const turning = <real>(t.dt + t.h) * (wa * (a.extent - a.radius) + wb * (b.extent - b.radius));
  const limit = a.radius + b.radius + turning - slack;
  poseOfB(bInA, m);
  const x = m.ac * wayX + m.as * wayY;
  const y = m.ac * wayY - m.as * wayX;
  if (goesBeside(a, b, bInA, x, y, limit)) return true;
  if (a.count < 2 || b.count < 2 || (a.isChained | b.isChained) != 0) return false;
  if (staysOutside(a, b, bInA, x, y, limit)) return true;
  invert(aInB, bInA);
  return staysOutside(b, a, aInB, -(m.bc * wayX + m.bs * wayY), m.bs * wayX - m.bc * wayY, limit);
}

// Whether a line along the way (x, y) of `second` in the frame of `first` is between the two.
function goesBeside(first: Shape, second: Shape, pose: RelativePose, x: real, y: real, limit: real): bool {
  const scale = <real>1 / sqrt<real>(x * x + y * y);
  const nx = -scale * y;
  const ny = scale * x;
  const along = nx * pose.x + ny * pose.y;
  const turnedX = pose.c * nx + pose.s * ny;
  const turnedY = pose.c * ny - pose.s * nx;
  const left = along + leastProjection(second, turnedX, turnedY) + leastProjection(first, -nx, -ny);
  const right = leastProjection(first, nx, ny) + leastProjection(second, -turnedX, -turnedY) - along;
  return max<real>(left, right) >= limit;
}

// Whether `second`, whose pose in the frame of `first` is given, stays outside of one edge as it moves by (x, y).
function staysOutside(first: Shape, second: Shape, pose: RelativePose, x: real, y: real, limit: real): bool {
  for (let i = 0; i < first.count; i++) {
    const along = normalX(first, i) * x + normalY(first, i) * y;
    if (distanceFromEdge(first, i, second, pose) + min<real>(0, along) >= limit) return true;
  }
  return false;
}
