// The distance of two convex outlines without their rounding, by the algorithm of Gilbert, Johnson and Keerthi (1988)
// with the sub-distances of Ericson, Real-time collision detection (2005), section 9.5. A simplex is a set of up to three
// differences of vertices; each turn keeps the part of it that is nearest to zero and adds the difference that is
// furthest in the direction from there to zero. It ends when that is one that the simplex had already.
import { PLANE, Shape, vertexX, vertexY } from '../../shapes/2d/shape';
import { planeDistance } from './plane-distance';
import { RelativePose, pointX, pointY } from './relative-pose';

@unmanaged
export class Distance {
  // The vertices of a and b that are nearest, or an end of the nearest edge.
  vertexA: i32;
  vertexB: i32;
  // Distance of the outlines, m; 0 where they overlap, and then there is no normal.
  distance: real;
  // Nearest points, and unit normal from a to b, in the frame of a.
  ax: real;
  ay: real;
  bx: real;
  by: real;
  nx: real;
  ny: real;
}

// A difference (x, y) of the vertices with index i of a and j of b; its weight at the point that is nearest to zero.
@unmanaged
class Corner {
  i: i32;
  j: i32;
  x: real;
  y: real;
  // The vertex of a.
  ax: real;
  ay: real;
  weight: real;
}

const CORNER: usize = (offsetof<Corner>() + 7) & ~7;
const simplex: usize = memory.data(((offsetof<Corner>() + 7) & ~7) * 3, 8);
let count: i32 = 0;

// A search that needs more turns than this goes in circles for lack of digits.
const MAX_TURNS: i32 = 20;

// @ts-ignore: decorator
@inline function corner(k: i32): Corner {
  return changetype<Corner>(simplex + <usize>k * CORNER);
}

// Finds the nearest points of two outlines; `pose` is that of b in the frame of a. A half-plane may only be the first.
export function closestPoints(result: Distance, a: Shape, b: Shape, pose: RelativePose): void {
  if (a.kind == PLANE) return planeDistance(result, a, b, pose);
  count = 0;
  addCorner(a, b, pose, pose.x, pose.y);
  corner(0).weight = 1;
  for (let turn = 0; turn < MAX_TURNS; turn++) {
    if (count == 3) keepNearestOfTriangle();
    else if (count == 2) keepNearestOfEdge();
    findNearest();
    if (count == 3) break;
    if (nearX * nearX + nearY * nearY < TOUCHING) break;
    if (!addCorner(a, b, pose, -nearX, -nearY)) break;
  }
  report(result);
}

// Square of a distance that counts as none: the normal would be noise.
const TOUCHING: real = sizeof<real>() == 4 ? <real>1e-18 : <real>1e-30;

// Adds the difference that is furthest in a direction, which is for b the opposite one. Returns whether it is new and
// further than what the simplex has.
function addCorner(a: Shape, b: Shape, pose: RelativePose, x: real, y: real): bool {
  const i = furthest(a, x, y);
  const j = furthest(b, -(pose.c * x + pose.s * y), pose.s * x - pose.c * y);
  for (let k = 0; k < count; k++) if (corner(k).i == i && corner(k).j == j) return false;
  const to = corner(count);
  to.i = i;
  to.j = j;
  to.ax = vertexX(a, i);
  to.ay = vertexY(a, i);
  to.x = to.ax - pointX(pose, vertexX(b, j), vertexY(b, j));
  to.y = to.ay - pointY(pose, vertexX(b, j), vertexY(b, j));
  for (let k = 0; k < count; k++) {
    if (x * to.x + y * to.y <= x * corner(k).x + y * corner(k).y) return false;
  }
  count++;
  return true;
}

function furthest(shape: Shape, x: real, y: real): i32 {
  let best = 0;
  let most = x * vertexX(shape, 0) + y * vertexY(shape, 0);
  for (let i = 1; i < shape.count; i++) {
    const reach = x * vertexX(shape, i) + y * vertexY(shape, i);
    if (reach <= most) continue;
    most = reach;
    best = i;
  }
  return best;
}

// The point of the simplex that is nearest to zero, and zero itself where the simplex has it inside.
let nearX: real = 0;
let nearY: real = 0;

// On an edge it is that of the line, across it: the sum of both ends by their weights lacks the digits where the edge is long.
function findNearest(): void {
  const p = corner(0);
  nearX = count == 1 ? p.x : <real>0;
  nearY = count == 1 ? p.y : <real>0;
  if (count != 2) return;
  const q = corner(1);
  const ex = q.x - p.x;
  const ey = q.y - p.y;
  const scale = cross(p, q) / (ex * ex + ey * ey);
  nearX = scale * ey;
  nearY = -(scale * ex);
}

// @ts-ignore: decorator
@inline function keepOne(k: i32): void {
  if (k != 0) memory.copy(simplex, simplex + <usize>k * CORNER, CORNER);
  corner(0).weight = 1;
  count = 1;
}

// Keeps corners 0 and k, or 1 and 2 as 2 and 1, with weights in this proportion.
// @ts-ignore: decorator
@inline function keepTwo(first: i32, second: i32, weightFirst: real, weightSecond: real): void {
  if (first != 0) memory.copy(simplex, simplex + <usize>first * CORNER, CORNER);
  if (second != 1) memory.copy(simplex + CORNER, simplex + <usize>second * CORNER, CORNER);
  const sum = weightFirst + weightSecond;
  corner(0).weight = weightFirst / sum;
  corner(1).weight = weightSecond / sum;
  count = 2;
}

// Projection of zero on the edge from corner p to q, measured from p, times the square of its length.
// @ts-ignore: decorator
@inline function along(p: Corner, q: Corner): real {
  return -(p.x * (q.x - p.x) + p.y * (q.y - p.y));
}

// @ts-ignore: decorator
@inline function cross(p: Corner, q: Corner): real {
  return p.x * q.y - p.y * q.x;
}

function keepNearestOfEdge(): void {
  const fromFirst = along(corner(0), corner(1));
  const fromSecond = along(corner(1), corner(0));
  if (fromFirst <= 0) keepOne(0);
  else if (fromSecond <= 0) keepOne(1);
  else keepTwo(0, 1, fromSecond, fromFirst);
}

// Leaves all three corners where zero is inside.
function keepNearestOfTriangle(): void {
  const p = corner(0);
  const q = corner(1);
  const r = corner(2);
  const pq = along(p, q);
  const qp = along(q, p);
  const pr = along(p, r);
  const rp = along(r, p);
  const qr = along(q, r);
  const rq = along(r, q);
  if (pq <= 0 && pr <= 0) return keepOne(0);
  if (qp <= 0 && qr <= 0) return keepOne(1);
  if (rp <= 0 && rq <= 0) return keepOne(2);
  const area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  const u = area * cross(q, r);
  const v = area * cross(r, p);
  const w = area * cross(p, q);
  if (w <= 0 && pq > 0 && qp > 0) return keepTwo(0, 1, qp, pq);
  if (v <= 0 && pr > 0 && rp > 0) return keepTwo(0, 2, rp, pr);
  if (u <= 0 && qr > 0 && rq > 0) return keepTwo(2, 1, qr, rq);
  const sum = u + v + w;
  p.weight = u / sum;
  q.weight = v / sum;
  r.weight = w / sum;
}

function report(result: Distance): void {
  const x = nearX;
  const y = nearY;
  const distance = count == 3 ? <real>0 : sqrt<real>(x * x + y * y);
  const isApart = distance * distance >= TOUCHING;
  result.distance = isApart ? distance : <real>0;
  result.nx = isApart ? -x / distance : <real>0;
  result.ny = isApart ? -y / distance : <real>0;
  result.ax = 0;
  result.ay = 0;
  for (let k = 0; k < count; k++) {
    result.ax += corner(k).weight * corner(k).ax;
    result.ay += corner(k).weight * corner(k).ay;
  }
  result.bx = result.ax - x;
  result.by = result.ay - y;
  result.vertexA = corner(0).i;
  result.vertexB = corner(0).j;
}
