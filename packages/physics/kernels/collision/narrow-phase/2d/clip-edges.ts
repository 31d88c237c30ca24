// Contact points of two convex outlines that are less than the speculative distance apart. The edge of the incident shape
// that faces the reference edge most is cut to the length of the reference edge, and its ends are the points. Source:
// Catto, Fast and simple physics using sequential impulses, GDC 2006. Where that finds no point, or only points further
// apart than the shapes are, the contact is one point between the nearest points of the two.
import { Shape, nextVertex, normalX, normalY, vertexX, vertexY } from '../../shapes/2d/shape';
import { Distance, closestPoints } from './distance';
import { EDGE_OF_A, EDGE_OF_B, FIRST_OF_B, KNOWN, Manifold, addRoundedPoint, setNormal } from './manifold';
import { RelativePose, pointX, pointY } from './relative-pose';

// A clipped point counts as the nearest of the shapes when it is no further than this beyond it, m: a tenth of the slop.
const TOLERANCE: real = 0.0005;

const nearest = changetype<Distance>(memory.data(offsetof<Distance>() + 8, 8));

// The points of `reference` and `incident`, whose pose in the frame of `reference` is given, in that frame. `separation`
// is the greatest of all edges of both, that of `edge` of the reference shape. With `isFaceOnly` there are no points but
// those on this edge.
export function clipEdges(
  m: Manifold,
  reference: Shape,
  incident: Shape,
  edge: i32,
  separation: real,
  pose: RelativePose,
  isFlipped: bool,
  isFaceOnly: bool = false,
): void {
  const nx = normalX(reference, edge);
  const ny = normalY(reference, edge);
  const startX = vertexX(reference, edge);
  const startY = vertexY(reference, edge);
  const end = nextVertex(reference, edge);
  const length = (vertexY(reference, end) - startY) * nx - (vertexX(reference, end) - startX) * ny;
  // The incident edge runs the other way: it begins where the reference edge ends.
  const high = incidentEdge(incident, pose.c * nx + pose.s * ny, pose.c * ny - pose.s * nx);
  const low = nextVertex(incident, high);
  const highX = pointX(pose, vertexX(incident, high), vertexY(incident, high)) - startX;
  const highY = pointY(pose, vertexX(incident, high), vertexY(incident, high)) - startY;
  const lowX = pointX(pose, vertexX(incident, low), vertexY(incident, low)) - startX;
  const lowY = pointY(pose, vertexX(incident, low), vertexY(incident, low)) - startY;
  // Coordinates along the reference edge and along its normal.
  const highAlong = highY * nx - highX * ny;
  const lowAlong = lowY * nx - lowX * ny;
  const highAway = highX * nx + highY * ny;
  const lowAway = lowX * nx + lowY * ny;
  const span = highAlong - lowAlong;
  const slope = span > 0 ? (highAway - lowAway) / span : <real>0;
  const lowCut = max<real>(lowAlong, 0);
  const highCut = min<real>(highAlong, length);
  const lowDistance = lowCut > lowAlong ? lowAway + (lowCut - lowAlong) * slope : lowAway;
  const highDistance = highCut < highAlong ? highAway + (highCut - highAlong) * slope : highAway;
  const overlaps = lowCut <= highCut;
  if (isFaceOnly && !overlaps) return;
  const least = overlaps ? min<real>(lowDistance, highDistance) : <real>Infinity;
  const mayBeNearer = !isFaceOnly && least > separation + TOLERANCE;
  if (mayBeNearer && meetAtNearestPoints(m, reference, incident, pose, isFlipped, least - TOLERANCE)) return;
  setNormal(m, nx, ny);
  m.edge = isFlipped ? EDGE_OF_B : EDGE_OF_A;
  if (!overlaps) {
    // The outlines overlap beyond an end of the reference edge: the deepest vertex stands for all.
    if (lowAway < highAway)
      addCut(m, startX, startY, lowAlong, lowAway, reference, incident, idOf(edge, low, isFlipped));
    else addCut(m, startX, startY, highAlong, highAway, reference, incident, idOf(end, high, isFlipped));
    return;
  }
  m.corners = KNOWN;
  addCut(m, startX, startY, lowCut, lowDistance, reference, incident, idOf(edge, low, isFlipped));
  // What is cut is a corner of the reference shape.
  if (m.count > 0 && lowCut > lowAlong == isFlipped) m.corners |= FIRST_OF_B;
  const second = m.count;
  addCut(m, startX, startY, highCut, highDistance, reference, incident, idOf(end, high, isFlipped));
  if (highCut < highAlong == isFlipped) m.corners |= FIRST_OF_B << second;
  m.room = min<real>(roomAt(lowAlong, length), roomAt(highAlong, length));
}

// How far a corner is from the nearer end of an edge of a length.
// @ts-ignore: decorator
@inline function roomAt(along: real, length: real): real {
  return min<real>(abs<real>(along), abs<real>(along - length));
}

// @ts-ignore: decorator
@inline function idOf(first: i32, second: i32, isFlipped: bool): u32 {
  return isFlipped ? ((<u32>second) << 8) | <u32>first : ((<u32>first) << 8) | <u32>second;
}

// The edge whose normal is most opposed to a direction of the shape's frame.
// @ts-ignore: decorator
@inline function incidentEdge(shape: Shape, x: real, y: real): i32 {
  if (shape.isBox != 0) {
    if (abs<real>(x) > abs<real>(y)) return x > 0 ? 3 : 1;
    return y > 0 ? 0 : 2;
  }
  let least = <real>Infinity;
  let edge = 0;
  for (let i = 0; i < shape.count; i++) {
    const facing = x * normalX(shape, i) + y * normalY(shape, i);
    if (facing >= least) continue;
    least = facing;
    edge = i;
  }
  return edge;
}

// A point at `along` on the reference edge.
// @ts-ignore: decorator
@inline function addCut(
  m: Manifold,
  startX: real,
  startY: real,
  along: real,
  distance: real,
  reference: Shape,
  incident: Shape,
  id: u32,
): void {
  addRoundedPoint(m, startX - along * m.ny, startY + along * m.nx, distance, reference, incident, id);
}

// Returns whether the nearest points, if they are less than `limit` apart, made the contact, or the shapes are too far
// apart for one. Outlines that overlap have no nearest points.
function meetAtNearestPoints(
  m: Manifold,
  reference: Shape,
  incident: Shape,
  pose: RelativePose,
  isFlipped: bool,
  limit: real,
): bool {
  closestPoints(nearest, reference, incident, pose);
  const distance = nearest.distance;
  if (distance <= 0 || distance >= limit) return false;
  setNormal(m, nearest.nx, nearest.ny);
  addRoundedPoint(
    m,
    nearest.ax,
    nearest.ay,
    distance,
    reference,
    incident,
    idOf(nearest.vertexA, nearest.vertexB, isFlipped),
  );
  return true;
}
