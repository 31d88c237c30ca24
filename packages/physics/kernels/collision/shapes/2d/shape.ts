// A convex shape in the frame of its body: the points within `radius` of a point, of a segment or of a polygon. Its
// centroid is the origin, because a body's position is its centre of mass. src/collision/shapes/shape-pool.ts writes
// these records: first the four integers, then all reals in this order.

export const CIRCLE: i32 = 0;
export const CAPSULE: i32 = 1;
export const POLYGON: i32 = 2;
export const SEGMENT: i32 = 3;
// A half-plane, only as a wall: solid behind the line through its origin with the normal nx0, ny0.
export const PLANE: i32 = 4;

export const MAX_VERTICES: i32 = 8;

@unmanaged
export class Shape {
  kind: i32;
  // Number of vertices: 1 for a circle, 2 for a capsule or a segment, 3 to 8 for a polygon.
  count: i32;
  // 1 for a rectangle whose vertices are (-x, -y), (x, -y), (x, y), (-x, y), which has faster tests.
  isBox: i32;
  // 1 for a segment of a chain, which only bodies on the side of its first normal meet: vertices 2 and 3 are then the
  // far ends of its neighbours before and after.
  isChained: i32;
  // Radius of a circle or of the caps of a capsule; rounding of a polygon. 0 for sharp corners.
  radius: real;
  // m²; 0 for a segment.
  area: real;
  // Moment of inertia about the origin per unit of mass, m².
  inertiaPerMass: real;
  // Greatest distance of the surface from the origin, m.
  extent: real;
  // Least distance of the surface from the origin, m: a body that moves less in a step passes through nothing.
  minExtent: real;
  // Vertices, anticlockwise. Those beyond `count` are zero.
  x0: real;
  y0: real;
  x1: real;
  y1: real;
  x2: real;
  y2: real;
  x3: real;
  y3: real;
  x4: real;
  y4: real;
  x5: real;
  y5: real;
  x6: real;
  y6: real;
  x7: real;
  y7: real;
  // Unit outward normal of the edge from vertex i to the next. A capsule and a segment have two edges, back to back.
  nx0: real;
  ny0: real;
  nx1: real;
  ny1: real;
  nx2: real;
  ny2: real;
  nx3: real;
  ny3: real;
  nx4: real;
  ny4: real;
  nx5: real;
  ny5: real;
  nx6: real;
  ny6: real;
  nx7: real;
  ny7: real;
}

// Bytes of a record.
// @ts-ignore: decorator
@inline export const SHAPE_BYTES: usize = (offsetof<Shape>() + sizeof<real>() - 1) & ~(sizeof<real>() - 1);

// @ts-ignore: decorator
@inline function part(shape: Shape, start: usize, i: i32): real {
  return load<real>(changetype<usize>(shape) + start + <usize>i * (2 * sizeof<real>()));
}

// @ts-ignore: decorator
@inline export function vertexX(shape: Shape, i: i32): real {
  return part(shape, offsetof<Shape>('x0'), i);
}

// @ts-ignore: decorator
@inline export function vertexY(shape: Shape, i: i32): real {
  return part(shape, offsetof<Shape>('y0'), i);
}

// @ts-ignore: decorator
@inline export function normalX(shape: Shape, i: i32): real {
  return part(shape, offsetof<Shape>('nx0'), i);
}

// @ts-ignore: decorator
@inline export function normalY(shape: Shape, i: i32): real {
  return part(shape, offsetof<Shape>('ny0'), i);
}

// @ts-ignore: decorator
@inline export function nextVertex(shape: Shape, i: i32): i32 {
  return i + 1 < shape.count ? i + 1 : 0;
}
