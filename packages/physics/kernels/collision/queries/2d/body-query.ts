// A question about the bodies of a world that have a collider: which of them a ray, a shape or a point meets. TypeScript
// fills the record, and asks for one body after the other in ascending order.
import { columns, get } from '../../../memory/columns';
import { cosine, sine } from '../../../math/elementary';
import { RelativePose } from '../../narrow-phase/2d/relative-pose';
import { SHAPE_BYTES, Shape } from '../../shapes/2d/shape';
import { extentOf } from '../../shapes/2d/shape-pool';

@unmanaged
export class BodyQuery {
  // Components that a body must have, layers of which it must be on one, a body that is left out, the last row.
  required: u32;
  mask: u32;
  ignored: i32;
  lastRow: i32;
  // Columns that are not in the table of columns.
  angle: usize;
  layers: usize;
  sensor: usize;
  // 1 to see sensors, too.
  seesSensors: i32;
  // Rows to visit, ascending; 0 for all.
  candidates: usize;
  candidateCount: i32;
  // Where a ray or a shape starts, m, the shape's cosine and sine, and where it moves to from there, m.
  x: real;
  y: real;
  c: real;
  s: real;
  dx: real;
  dy: real;
  // Fraction of the movement beyond which hits do not count.
  limit: real;
  // Distance from the path at which the surface of a body is still of interest, m.
  reach: real;
  // The body found: fraction of the movement, or distance, m; outward normal of its surface; the point on it, m.
  fraction: real;
  nx: real;
  ny: real;
  pointX: real;
  pointY: real;
}

// For a shape that the query does not name, and for colliders that are only a radius.
const spareShape: usize = memory.data(<i32>SHAPE_BYTES, 8);
const POSE = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

// @ts-ignore: decorator
@inline export function queryAt(address: usize): BodyQuery {
  return changetype<BodyQuery>(address);
}

// @ts-ignore: decorator
@inline export function spare(): Shape {
  return changetype<Shape>(spareShape);
}

// The first body from `row` on whose bounding circle comes within reach of the path, 0 if there is none.
export function nextNear(q: BodyQuery, row: i32): i32 {
  const c = columns();
  const pathX = q.limit * q.dx;
  const pathY = q.limit * q.dy;
  const inverse = inverseSquare(pathX, pathY);
  const listed = q.candidates != 0;
  let k = listed ? firstCandidate(q, row) : row;
  const end = listed ? q.candidateCount : q.lastRow + 1;
  for (; k < end; k++) {
    const r = listed ? load<i32>(q.candidates + ((<usize>k) << 2)) : k;
    if ((load<u32>(c.members + ((<usize>r) << 2)) & q.required) != q.required) continue;
    if ((load<u32>(q.layers + ((<usize>r) << 2)) & q.mask) == 0 || r == q.ignored) continue;
    if (q.seesSensors == 0 && load<u32>(q.sensor + ((<usize>r) << 2)) != 0) continue;
    const toX = get(c.positionX, r) - q.x;
    const toY = get(c.positionY, r) - q.y;
    if (comesNear(toX, toY, pathX, pathY, inverse, extentOf(r) + q.reach)) return r;
  }
  return 0;
}

// Whether a circle comes within reach of the path; its centre is given from the start of the path.
export function isNearPath(q: BodyQuery, toX: real, toY: real, radius: real): bool {
  const pathX = q.limit * q.dx;
  const pathY = q.limit * q.dy;
  return comesNear(toX, toY, pathX, pathY, inverseSquare(pathX, pathY), radius + q.reach);
}

// @ts-ignore: decorator
@inline function inverseSquare(x: real, y: real): real {
  const square = x * x + y * y;
  return square > 0 ? <real>1 / square : <real>0;
}

// @ts-ignore: decorator
@inline function comesNear(toX: real, toY: real, pathX: real, pathY: real, inverse: real, reach: real): bool {
  const along = min<real>(max<real>((toX * pathX + toY * pathY) * inverse, 0), 1);
  const offX = toX - along * pathX;
  const offY = toY - along * pathY;
  return offX * offX + offY * offY <= reach * reach;
}

// The index of the first candidate from a row on: a binary search.
function firstCandidate(q: BodyQuery, row: i32): i32 {
  let low = 0;
  let high = q.candidateCount;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (load<i32>(q.candidates + ((<usize>middle) << 2)) < row) low = middle + 1;
    else high = middle;
  }
  return low;
}

// The pose of a body from the point where the query starts, in the axes of the world.
export function poseFromQuery(q: BodyQuery, row: i32): RelativePose {
  const c = columns();
  const angle = <f64>get(q.angle, row);
  POSE.x = get(c.positionX, row) - q.x;
  POSE.y = get(c.positionY, row) - q.y;
  POSE.c = <real>cosine(angle);
  POSE.s = <real>sine(angle);
  return POSE;
}
