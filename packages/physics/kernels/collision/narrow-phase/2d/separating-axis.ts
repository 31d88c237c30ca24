// The separating axis theorem: two convex outlines are apart where one of them has an edge with the whole of the other on
// its outer side. Of all edges the one with the greatest distance is the reference edge of a contact. Source: Ericson,
// Real-time collision detection (2005), section 5.2.1.
import { Shape, normalX, normalY, vertexX, vertexY } from '../../shapes/2d/shape';
import { RelativePose } from './relative-pose';

// What `greatestSeparation` found last: the distance, and the edge of the first shape.
export let separation: real = 0;
export let separatingEdge: i32 = 0;

// The greatest signed distance of `second`, whose pose in the frame of `first` is given, from an edge of `first`.
// Stops at the first distance above `limit`.
export function greatestSeparation(first: Shape, second: Shape, pose: RelativePose, limit: real): void {
  separation = -(<real>Infinity);
  for (let i = 0; i < first.count; i++) {
    const distance = distanceFromEdge(first, i, second, pose);
    if (distance <= separation) continue;
    separation = distance;
    separatingEdge = i;
    if (distance > limit) return;
  }
}

// The signed distance of `second` from the line through an edge of `first`.
// @ts-ignore: decorator
@inline export function distanceFromEdge(first: Shape, edge: i32, second: Shape, pose: RelativePose): real {
  const nx = normalX(first, edge);
  const ny = normalY(first, edge);
  const toCentre = nx * (pose.x - vertexX(first, edge)) + ny * (pose.y - vertexY(first, edge));
  return toCentre + leastProjection(second, pose.c * nx + pose.s * ny, pose.c * ny - pose.s * nx);
}

// How far the vertices of a shape reach along a direction of its frame, at least.
// @ts-ignore: decorator
@inline export function leastProjection(shape: Shape, x: real, y: real): real {
  let least = x * vertexX(shape, 0) + y * vertexY(shape, 0);
  for (let j = 1; j < shape.count; j++) least = min<real>(least, x * vertexX(shape, j) + y * vertexY(shape, j));
  return least;
}

// The same for two boxes, whose corners are half-widths from their centres.
export function greatestBoxSeparation(first: Shape, second: Shape, pose: RelativePose): void {
  const c = abs<real>(pose.c);
  const s = abs<real>(pose.s);
  const alongX = abs<real>(pose.x) - first.x2 - (c * second.x2 + s * second.y2);
  const alongY = abs<real>(pose.y) - first.y2 - (s * second.x2 + c * second.y2);
  if (alongX > alongY) {
    separation = alongX;
    separatingEdge = pose.x > 0 ? 1 : 3;
  } else {
    separation = alongY;
    separatingEdge = pose.y > 0 ? 2 : 0;
  }
}
