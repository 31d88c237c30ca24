// Distances of a shape, or of a point, which is a disc without radius, from bodies.
import { Distance, closestPoints } from '../../narrow-phase/2d/distance';
import { planeDistance } from '../../narrow-phase/2d/plane-distance';
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
    measure(q, own, shapeOf(r, spare()), poseFromQuery(q, r));
    if (isWithinReach(q, own)) return r;
  }
  return 0;
}

// @ts-ignore: decorator
@inline export function isWithinReach(q: BodyQuery, own: Shape): bool {
  return q.fraction <= q.reach - own.extent;
}

// Distance of the surfaces, 0 where they overlap, and the point on the other shape, whose pose is that from the query.
export function measure(q: BodyQuery, own: Shape, shape: Shape, pose: RelativePose): void {
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

// As `measure` from a half-plane, whose frame is not turned.
export function measurePlane(q: BodyQuery, own: Shape, plane: Shape, pose: RelativePose): void {
  inQuery.x = -pose.x;
  inQuery.y = -pose.y;
  inQuery.c = q.c;
  inQuery.s = q.s;
  planeDistance(nearest, plane, own, inQuery);
  q.fraction = max<real>(nearest.distance - own.radius, 0);
  q.nx = plane.nx0;
  q.ny = plane.ny0;
  q.pointX = q.x + pose.x + nearest.ax;
  q.pointY = q.y + pose.y + nearest.ay;
}
