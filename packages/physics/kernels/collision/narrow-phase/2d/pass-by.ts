// Whether two outlines pass each other in a step without touching: where one of them has an edge that the other stays outside of all
// the way. A box that falls into a slot as wide as itself does so, and must not be held up by the corners of the slot, which are
// straight below its own until it has passed them.
//
//   distance + min(0, n · u) ≥ margin         of an edge with the normal n, as the other outline moves by u
import { Shape, normalX, normalY, vertexX, vertexY } from '../../shapes/2d/shape';
import { Manifold } from './manifold';
import { RelativePose, invert, poseOfB } from './relative-pose';
import { leastProjection } from './separating-axis';

const bInA = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));
const aInB = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

// For b that moves by (x, y) beside a.
export function passBy(m: Manifold, a: Shape, b: Shape, x: real, y: real, margin: real): bool {
  const limit = a.radius + b.radius + margin;
  poseOfB(bInA, m);
  if (staysOutside(a, b, bInA, m.ac * x + m.as * y, m.ac * y - m.as * x, limit)) return true;
  invert(aInB, bInA);
  return staysOutside(b, a, aInB, -(m.bc * x + m.bs * y), m.bs * x - m.bc * y, limit);
}

// Whether `second`, whose pose in the frame of `first` is given, stays outside of one edge as it moves by (x, y).
function staysOutside(first: Shape, second: Shape, pose: RelativePose, x: real, y: real, limit: real): bool {
  for (let i = 0; i < first.count; i++) {
    const nx = normalX(first, i);
    const ny = normalY(first, i);
    const toCentre = nx * (pose.x - vertexX(first, i)) + ny * (pose.y - vertexY(first, i));
    const distance = toCentre + leastProjection(second, pose.c * nx + pose.s * ny, pose.c * ny - pose.s * nx);
    if (distance + min<real>(0, nx * x + ny * y) >= limit) return true;
  }
  return false;
}
