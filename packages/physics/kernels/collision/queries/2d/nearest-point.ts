// Distances of a shape, or of a point, which is a disc without radius, from bodies.
import { Distance, closestPoints } from '../../narrow-phase/2d/distance';
import { RelativePose } from '../../narrow-phase/2d/relative-pose';
import { Shape } from '../../shapes/2d/shape';
import { shapeOf } from '../../shapes/2d/shape-pool';
import { BodyQuery, nextNear, poseFromQuery, queryAt, spare } from './body-query';

const nearest = changetype<Distance>(memory.data(offsetof<Distance>() + 8, 8));
const inQuery = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

// Returns the first body from `row` on whose surface is within reach of the surface of the shape at this address, 0 if
// there is none. The reach of the query counts from the centre of the shape.
export function nextNearBody(query: usize, shape: usize, row: i32): i32 {
  const q = queryAt(query);
  const own = changetype<Shape>(shape);
  for (let r = nextNear(q, row); r > 0; r = nextNear(q, r + 1)) {
    measure(q, own, r);
    if (q.fraction <= q.reach - own.extent) return r;
  }
  return 0;
}

// Distance of the surfaces, 0 where they overlap, and the point on the body.
function measure(q: BodyQuery, own: Shape, row: i32): void {
  const shape = shapeOf(row, spare());
  const pose = poseFromQuery(q, row);
  inQuery.x = q.c * pose.x + q.s * pose.y;
  inQuery.y = q.c * pose.y - q.s * pose.x;
  inQuery.c = q.c * pose.c + q.s * pose.s;
  inQuery.s = q.c * pose.s - q.s * pose.c;
  closestPoints(nearest, own, shape, inQuery);
  const distance = nearest.distance - own.radius - shape.radius;
  const nx = -(q.c * nearest.nx - q.s * nearest.ny);
  const ny = -(q.s * nearest.nx + q.c * nearest.ny);
  // Where they overlap the point is one in both, as far as it is known.
  const outward = distance > 0 ? shape.radius : min<real>(shape.radius, nearest.distance);
  q.fraction = max<real>(distance, 0);
  q.nx = nx;
  q.ny = ny;
  q.pointX = q.x + (q.c * nearest.bx - q.s * nearest.by) + outward * nx;
  q.pointY = q.y + (q.s * nearest.bx + q.c * nearest.by) + outward * ny;
}
