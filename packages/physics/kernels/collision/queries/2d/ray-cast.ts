// Where a ray enters a shape: on one of its edges, moved outward by the rounding, or on the arc about one of its vertices.
// A ray that starts inside a shape does not enter it.
import { RelativePose } from '../../narrow-phase/2d/relative-pose';
import { Shape, nextVertex, normalX, normalY, vertexX, vertexY } from '../../shapes/2d/shape';
import { shapeOf } from '../../shapes/2d/shape-pool';
import { BodyQuery, nextNear, poseFromQuery, queryAt, spare } from './body-query';

// Where the ray entered: fraction of its length, and normal in the frame of the shape.
let fraction: real = 0;
let entryX: real = 0;
let entryY: real = 0;

// Returns the first body from `row` on that the ray enters within the limit, 0 if there is none.
export function nextRayHit(query: usize, row: i32): i32 {
  const q = queryAt(query);
  for (let r = nextNear(q, row); r > 0; r = nextNear(q, r + 1))
    if (rayMeets(q, shapeOf(r, spare()), poseFromQuery(q, r))) return r;
  return 0;
}

// The pose is that from the start of the ray.
export function rayMeets(q: BodyQuery, shape: Shape, pose: RelativePose): bool {
  const x = -(pose.c * pose.x + pose.s * pose.y);
  const y = pose.s * pose.x - pose.c * pose.y;
  const dx = pose.c * q.dx + pose.s * q.dy;
  const dy = pose.c * q.dy - pose.s * q.dx;
  fraction = q.limit;
  if (contains(shape, x, y)) return false;
  const onEdge = entersEdge(shape, x, y, dx, dy);
  const onArc = shape.radius > 0 && entersArc(shape, x, y, dx, dy);
  if (!onEdge && !onArc) return false;
  q.fraction = fraction;
  q.nx = pose.c * entryX - pose.s * entryY;
  q.ny = pose.s * entryX + pose.c * entryY;
  q.pointX = q.x + fraction * q.dx;
  q.pointY = q.y + fraction * q.dy;
  return true;
}

// As `rayMeets` of a half-plane: a ray enters it where it crosses the line from the side of the normal.
export function rayMeetsPlane(q: BodyQuery, plane: Shape, pose: RelativePose): bool {
  const height = -(plane.nx0 * pose.x + plane.ny0 * pose.y);
  const rate = plane.nx0 * q.dx + plane.ny0 * q.dy;
  if (height < 0 || rate >= 0) return false;
  const t = -height / rate;
  if (t > q.limit) return false;
  q.fraction = t;
  q.nx = plane.nx0;
  q.ny = plane.ny0;
  q.pointX = q.x + t * q.dx;
  q.pointY = q.y + t * q.dy;
  return true;
}

// A ray that passes an end of an edge no further than this beyond it, in units of the coordinates, meets it: or one to a corner, where two
// edges end, could pass between both.
const ROUNDING: real = sizeof<real>() == 4 ? <real>5e-7 : <real>1e-15;

function entersEdge(shape: Shape, x: real, y: real, dx: real, dy: real): bool {
  let enters = false;
  if (shape.count == 1) return false;
  const length = sqrt<real>(dx * dx + dy * dy);
  for (let i = 0; i < shape.count; i++) {
    const nx = normalX(shape, i);
    const ny = normalY(shape, i);
    const rate = nx * dx + ny * dy;
    if (rate >= 0) continue;
    const fromX = x - vertexX(shape, i);
    const fromY = y - vertexY(shape, i);
    const t = (shape.radius - (nx * fromX + ny * fromY)) / rate;
    if (t < 0 || t > fraction) continue;
    const end = nextVertex(shape, i);
    const edgeX = vertexX(shape, end) - vertexX(shape, i);
    const edgeY = vertexY(shape, end) - vertexY(shape, i);
    const along = (fromX + t * dx) * edgeX + (fromY + t * dy) * edgeY;
    const edge = edgeX * edgeX + edgeY * edgeY;
    const beyond = max<real>(-along, along - edge);
    if (beyond > 0) {
      // The ray passes the corner as far away as its point is from it along the edge, times the sine of the angle between both.
      const size = abs<real>(x) + abs<real>(y) + t * length + abs<real>(fromX - x) + abs<real>(fromY - y);
      if (beyond * -rate > ROUNDING * size * length * sqrt<real>(edge)) continue;
    }
    enters = true;
    fraction = t;
    entryX = nx;
    entryY = ny;
  }
  return enters;
}

// |from + t d|² = radius², of which the smaller root is where the ray enters.
function entersArc(shape: Shape, x: real, y: real, dx: real, dy: real): bool {
  let enters = false;
  const square = dx * dx + dy * dy;
  for (let i = 0; i < shape.count; i++) {
    const fromX = x - vertexX(shape, i);
    const fromY = y - vertexY(shape, i);
    const rate = fromX * dx + fromY * dy;
    if (rate >= 0) continue;
    // Distance of the line from the vertex, which keeps digits that the usual discriminant loses.
    const offset = fromX * dy - fromY * dx;
    const rest = shape.radius * shape.radius * square - offset * offset;
    if (rest < 0) continue;
    const t = -(rate + sqrt<real>(rest)) / square;
    if (t < 0 || t > fraction) continue;
    enters = true;
    fraction = t;
    entryX = fromX + t * dx;
    entryY = fromY + t * dy;
    // What is far from its start meets a small disc beside its surface, by rounding.
    const size = sqrt<real>(entryX * entryX + entryY * entryY);
    entryX /= size;
    entryY /= size;
  }
  return enters;
}

// Whether a point is inside a shape, not on its surface.
function contains(shape: Shape, x: real, y: real): bool {
  const square = shape.radius * shape.radius;
  let isInCore = shape.count > 2;
  for (let i = 0; i < shape.count; i++) {
    const fromX = x - vertexX(shape, i);
    const fromY = y - vertexY(shape, i);
    if (fromX * fromX + fromY * fromY < square) return true;
    if (shape.count == 1) return false;
    const away = fromX * normalX(shape, i) + fromY * normalY(shape, i);
    if (away >= 0) isInCore = false;
    if (away < 0 || away >= shape.radius) continue;
    const end = nextVertex(shape, i);
    const edgeX = vertexX(shape, end) - vertexX(shape, i);
    const edgeY = vertexY(shape, end) - vertexY(shape, i);
    const along = fromX * edgeX + fromY * edgeY;
    if (along >= 0 && along <= edgeX * edgeX + edgeY * edgeY) return true;
  }
  return isInCore;
}
