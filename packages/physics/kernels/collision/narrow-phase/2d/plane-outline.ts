// Contact of a half-plane, solid below the line through its origin, and any other shape: the vertex that is nearest to the
// line or deepest below it, and the nearer of its neighbours.
import { Shape, vertexX, vertexY } from '../../shapes/2d/shape';
import { EDGE_OF_A, Manifold, addPoint, setNormal } from './manifold';
import { RelativePose, pointX, pointY } from './relative-pose';

// The vertex of an outline with the least distance from a plane through the origin of the frame of `pose`.
export function lowestVertex(plane: Shape, outline: Shape, pose: RelativePose): i32 {
  let lowest = 0;
  let least = distanceOf(plane, outline, pose, 0);
  for (let i = 1; i < outline.count; i++) {
    const distance = distanceOf(plane, outline, pose, i);
    if (distance >= least) continue;
    least = distance;
    lowest = i;
  }
  return lowest;
}

// @ts-ignore: decorator
@inline export function distanceOf(plane: Shape, outline: Shape, pose: RelativePose, i: i32): real {
  const x = pointX(pose, vertexX(outline, i), vertexY(outline, i));
  const y = pointY(pose, vertexX(outline, i), vertexY(outline, i));
  return plane.nx0 * x + plane.ny0 * y;
}

const inPlane = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

// The plane is the first shape, and its frame is not turned.
export function collidePlane(m: Manifold, plane: Shape, outline: Shape): void {
  inPlane.x = m.bx - m.ax;
  inPlane.y = m.by - m.ay;
  inPlane.c = m.bc;
  inPlane.s = m.bs;
  setNormal(m, plane.nx0, plane.ny0);
  const lowest = lowestVertex(plane, outline, inPlane);
  addVertex(m, plane, outline, lowest);
  if (m.count == 0 || outline.count == 1) return;
  m.edge = EDGE_OF_A;
  const before = lowest == 0 ? outline.count - 1 : lowest - 1;
  const after = lowest + 1 == outline.count ? 0 : lowest + 1;
  const isBefore = distanceOf(plane, outline, inPlane, before) < distanceOf(plane, outline, inPlane, after);
  addVertex(m, plane, outline, isBefore ? before : after);
}

function addVertex(m: Manifold, plane: Shape, outline: Shape, i: i32): void {
  const distance = distanceOf(plane, outline, inPlane, i);
  const down = <real>0.5 * (distance + outline.radius);
  const x = pointX(inPlane, vertexX(outline, i), vertexY(outline, i)) - down * plane.nx0;
  const y = pointY(inPlane, vertexX(outline, i), vertexY(outline, i)) - down * plane.ny0;
  addPoint(m, m.ax + x, m.ay + y, distance - outline.radius, <u32>i);
}
