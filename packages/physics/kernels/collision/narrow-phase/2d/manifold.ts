// The contact of two shapes: up to two points with a common normal.
import { Shape } from '../../shapes/2d/shape';

@unmanaged
export class Manifold {
  // Points found, 0 to 2.
  count: i32;
  // Feature ids: the vertices of a (high byte) and b (low byte) that made a point. They stay the same from step to step
  // while the same corners and edges touch, whichever of the two shapes has the reference edge.
  id0: u32;
  id1: u32;
  // Pose of a and of b: position, m, then cosine and sine of the angle.
  ax: real;
  ay: real;
  ac: real;
  as: real;
  bx: real;
  by: real;
  bc: real;
  bs: real;
  // Shapes further apart than this have no contact, m.
  speculative: real;
  // Points of a contact that are further apart than this are left out, m.
  reach: real;
  // Unit normal from a to b.
  nx: real;
  ny: real;
  // Points half-way between the surfaces, m, and the distance of the surfaces there, negative where they overlap.
  x0: real;
  y0: real;
  separation0: real;
  x1: real;
  y1: real;
  separation1: real;
  // Whose edge the normal is of: EDGE_OF_A, EDGE_OF_B, or 0 where it is that of two corners or of discs.
  edge: u32;
  // Whose corners the points are: 0 where that is not known, else KNOWN and bits of the points that are corners of b.
  corners: u32;
  // How far one of the two may slide along the other until another corner, or an end of another edge, takes part, m.
  room: real;
}

// Bits of `corners`.
export const FIRST_OF_B: u32 = 1;
export const SECOND_OF_B: u32 = 2;
export const KNOWN: u32 = 4;

// Values of `edge`, which are bits of the flags of a contact (rigid-contact.ts).
export const EDGE_OF_A: u32 = 8192;
export const EDGE_OF_B: u32 = 16384;

// Sets the poses of two shapes, with the position of b from a: far from the origin the difference of both has digits that they
// lack.
// @ts-ignore: decorator
@inline export function setPoses(m: Manifold, x: real, y: real, ac: real, as: real, bc: real, bs: real): void {
  m.ax = 0;
  m.ay = 0;
  m.ac = ac;
  m.as = as;
  m.bx = x;
  m.by = y;
  m.bc = bc;
  m.bs = bs;
}

// Sets the normal. Pair functions write normal and points in the frame of their first shape; `toWorld` comes last.
// @ts-ignore: decorator
@inline export function setNormal(m: Manifold, nx: real, ny: real): void {
  m.nx = nx;
  m.ny = ny;
}

// Adds a point unless it is further away than is asked for.
// @ts-ignore: decorator
@inline export function addPoint(m: Manifold, x: real, y: real, separation: real, id: u32): void {
  if (separation > m.reach) return;
  if (m.count == 0) {
    m.x0 = x;
    m.y0 = y;
    m.separation0 = separation;
    m.id0 = id;
  } else {
    m.x1 = x;
    m.y1 = y;
    m.separation1 = separation;
    m.id1 = id;
  }
  m.count++;
}

// Leaves out all points where none is near enough for a contact.
// @ts-ignore: decorator
@inline export function dropFar(m: Manifold): void {
  const first = m.count > 0 ? m.separation0 : <real>Infinity;
  const second = m.count > 1 ? m.separation1 : <real>Infinity;
  if (min<real>(first, second) > m.speculative) m.count = 0;
}

// Leaves out one of two points.
export function dropPoint(m: Manifold, i: i32): void {
  m.count = 1;
  if (i == 1) return;
  m.corners = (m.corners & KNOWN) | ((m.corners & SECOND_OF_B) >> 1);
  m.x0 = m.x1;
  m.y0 = m.y1;
  m.separation0 = m.separation1;
  m.id0 = m.id1;
}

// Adds the point between a core point of the first shape and one of the second: each is `radius` inside its surface, and
// the two are `distance` apart along the normal.
// @ts-ignore: decorator
@inline export function addRoundedPoint(
  m: Manifold,
  x: real,
  y: real,
  distance: real,
  first: Shape,
  second: Shape,
  id: u32,
): void {
  const middle = <real>0.5 * (first.radius + distance - second.radius);
  addPoint(m, x + middle * m.nx, y + middle * m.ny, distance - first.radius - second.radius, id);
}

// Moves normal and points from the frame of a into the world, or from that of b, where the normal is from b to a.
// @ts-ignore: decorator
@inline export function toWorld(m: Manifold, isFlipped: bool): void {
  if (m.count == 0) return;
  const x = isFlipped ? m.bx : m.ax;
  const y = isFlipped ? m.by : m.ay;
  const c = isFlipped ? m.bc : m.ac;
  const s = isFlipped ? m.bs : m.as;
  const sign: real = isFlipped ? -1 : 1;
  const nx = m.nx;
  m.nx = sign * (c * nx - s * m.ny);
  m.ny = sign * (s * nx + c * m.ny);
  const x0 = m.x0;
  m.x0 = x + (c * x0 - s * m.y0);
  m.y0 = y + (s * x0 + c * m.y0);
  const x1 = m.x1;
  m.x1 = x + (c * x1 - s * m.y1);
  m.y1 = y + (s * x1 + c * m.y1);
}

// Exchanges the two shapes: their poses, the direction of the normal, and the bytes of the ids.
export function swapShapes(m: Manifold): void {
  const x = m.ax;
  const y = m.ay;
  const c = m.ac;
  const s = m.as;
  m.ax = m.bx;
  m.ay = m.by;
  m.ac = m.bc;
  m.as = m.bs;
  m.bx = x;
  m.by = y;
  m.bc = c;
  m.bs = s;
  m.nx = -m.nx;
  m.ny = -m.ny;
  m.id0 = ((m.id0 & 255) << 8) | (m.id0 >> 8);
  m.id1 = ((m.id1 & 255) << 8) | (m.id1 >> 8);
  if (m.edge != 0) m.edge = EDGE_OF_A + EDGE_OF_B - m.edge;
  if (m.corners != 0) m.corners ^= FIRST_OF_B | SECOND_OF_B;
}
