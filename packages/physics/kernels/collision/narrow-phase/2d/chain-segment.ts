// Contact of a segment of a chain. Bodies meet it from the side of its first normal only, and slide over the vertices
// between segments as over one surface: a normal that no point of the chain's surface has is either that of the segment,
// or belongs to a contact with the neighbour. Source: the idea is that of chain shapes in Box2D 3 (manifold.c).
//
// The surface has at a convex vertex all normals between those of its two segments, and at a concave or flat one none
// but those.
import { CIRCLE, PLANE, Shape, normalX, normalY, vertexX, vertexY } from '../../shapes/2d/shape';
import { clipEdges } from './clip-edges';
import { Manifold, addRoundedPoint, setNormal, toWorld } from './manifold';
import { collidePolygons } from './polygon-polygon';
import { RelativePose, poseOfB } from './relative-pose';

const otherInChain = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

// Sine of the angle by which a normal may differ from one that the surface has.
const TOLERANCE: real = 0.01;

// The vertices of a chained segment: the far end of the neighbour before, its own two, the far end of the neighbour after.
export const BEFORE: i32 = 2;
export const START: i32 = 0;
export const END: i32 = 1;
export const AFTER: i32 = 3;

export function collideChainSegment(m: Manifold, chain: Shape, other: Shape): void {
  poseOfB(otherInChain, m);
  const x = otherInChain.x;
  const y = otherInChain.y;
  // What has its centre behind the segment comes from there, and passes.
  if (isBehind(chain, x, y)) return;
  if (other.kind == CIRCLE) collideCircle(m, chain, other, x, y);
  else collideOutline(m, chain, other);
}

// A half-plane is marked as chained, too, and has no vertices.
// @ts-ignore: decorator
@inline export function isChainSegment(shape: Shape): bool {
  return shape.isChained != 0 && shape.kind != PLANE;
}

// Whether a point of the frame of the segment is on the side that bodies pass.
// @ts-ignore: decorator
@inline export function isBehind(chain: Shape, x: real, y: real): bool {
  return (x - vertexX(chain, START)) * normalX(chain, 0) + (y - vertexY(chain, START)) * normalY(chain, 0) < 0;
}

// Of a vector of the frame of the segment, the component along the edge between two of its vertices.
// @ts-ignore: decorator
@inline function alongEdge(chain: Shape, from: i32, to: i32, x: real, y: real): real {
  return x * (vertexX(chain, to) - vertexX(chain, from)) + y * (vertexY(chain, to) - vertexY(chain, from));
}

// The edge that ends in a vertex meets discs at this vertex; the next one does not.
function collideCircle(m: Manifold, chain: Shape, circle: Shape, x: real, y: real): void {
  const fromEndX = x - vertexX(chain, END);
  const fromEndY = y - vertexY(chain, END);
  if (alongEdge(chain, START, END, x - vertexX(chain, START), y - vertexY(chain, START)) < 0) return;
  if (alongEdge(chain, START, END, fromEndX, fromEndY) > 0) {
    if (alongEdge(chain, END, AFTER, fromEndX, fromEndY) > 0) return;
    const distance = sqrt<real>(fromEndX * fromEndX + fromEndY * fromEndY);
    setNormal(m, fromEndX / distance, fromEndY / distance);
    addRoundedPoint(m, vertexX(chain, END), vertexY(chain, END), distance, chain, circle, 0);
  } else {
    const nx = normalX(chain, 0);
    const ny = normalY(chain, 0);
    const distance = fromEndX * nx + fromEndY * ny;
    setNormal(m, nx, ny);
    addRoundedPoint(m, x - distance * nx, y - distance * ny, distance, chain, circle, 0);
  }
  toWorld(m, false);
}

function collideOutline(m: Manifold, chain: Shape, other: Shape): void {
  collidePolygons(m, chain, other);
  if (m.count == 0) return;
  // The normal in the frame of the segment: x along the edge, y along the segment's normal.
  const nx = normalX(chain, 0);
  const ny = normalY(chain, 0);
  const localX = m.ac * m.nx + m.as * m.ny;
  const localY = m.ac * m.ny - m.as * m.nx;
  const tilt = localY * nx - localX * ny;
  const facing = localX * nx + localY * ny;
  // What lies flat on the segment gets its normal exactly, or a force along it would come of every rounding error.
  const isLeaning = facing > 0 && abs<real>(tilt) > TOLERANCE;
  const isConvex =
    isLeaning && (tilt < 0 ? turnAt(chain, BEFORE, START, END) : turnAt(chain, START, END, AFTER)) > TOLERANCE;
  const isBetween =
    isConvex && (tilt < 0 ? isAfter(chain, BEFORE, START, localX, localY) : isAfter(chain, AFTER, END, localX, localY));
  if (isBetween) return;
  // The neighbour is nearer. But a corner that is below both segments has a face that is nearer to the end of each: then there
  // are two contacts, each on its own segment.
  const depth = -(m.count > 1 ? min<real>(m.separation0, m.separation1) : m.separation0);
  m.count = 0;
  if (isConvex && depth <= chain.radius + other.radius) return;
  clipEdges(m, chain, other, 0, 0, otherInChain, false, true);
  toWorld(m, false);
}

// Sine of the angle by which the chain turns to the left at a vertex, which is convex where it is positive.
export function turnAt(chain: Shape, before: i32, at: i32, after: i32): real {
  const ax = vertexX(chain, at) - vertexX(chain, before);
  const ay = vertexY(chain, at) - vertexY(chain, before);
  const bx = vertexX(chain, after) - vertexX(chain, at);
  const by = vertexY(chain, after) - vertexY(chain, at);
  return (ax * by - ay * bx) / sqrt<real>((ax * ax + ay * ay) * (bx * bx + by * by));
}

// Whether a unit normal has not turned from that of the segment beyond that of the neighbour between these vertices: then
// it does not lean along the neighbour, away from the segment.
function isAfter(chain: Shape, far: i32, near: i32, x: real, y: real): bool {
  const ex = vertexX(chain, far) - vertexX(chain, near);
  const ey = vertexY(chain, far) - vertexY(chain, near);
  return x * ex + y * ey <= TOLERANCE * sqrt<real>(ex * ex + ey * ey);
}
