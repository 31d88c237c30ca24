// Queries about walls that are no bodies: TypeScript places one after the other, and asks whether the query meets it. They
// need no solver, so that worlds of particles have them, too.
import { PLANE, SHAPE_BYTES, Shape } from '../../shapes/2d/shape';
import { makePlane, makeSegment } from '../../shapes/2d/wall-shapes';
import { RelativePose } from '../../narrow-phase/2d/relative-pose';
import { BodyQuery, isNearPath, queryAt } from './body-query';
import { isWithinReach, measure, measurePlane } from './nearest-point';
import { rayMeets, rayMeetsPlane } from './ray-cast';
import { castMeets } from './shape-cast';

const wall = changetype<Shape>(memory.data(<i32>SHAPE_BYTES, 8));
// Its pose from the point where the query starts.
const pose = changetype<RelativePose>(memory.data(offsetof<RelativePose>() + 8, 8));

// Makes a segment the wall of the query. Returns 0 where it is out of reach, and where it has no length or is not finite.
export function placeSegment(query: usize, ax: real, ay: real, bx: real, by: real): i32 {
  const q = queryAt(query);
  const halfX = <real>0.5 * (bx - ax);
  const halfY = <real>0.5 * (by - ay);
  const half = sqrt<real>(halfX * halfX + halfY * halfY);
  pose.x = <real>0.5 * (ax + bx) - q.x;
  pose.y = <real>0.5 * (ay + by) - q.y;
  pose.c = 1;
  pose.s = 0;
  if (!(half > 0) || !isFinite<real>(half + pose.x + pose.y)) return 0;
  if (!isNearPath(q, pose.x, pose.y, half)) return 0;
  makeSegment(wall, halfX, halfY, half);
  return 1;
}

// Makes a half-plane the wall of the query: solid where n·x < offset. It lies about the foot of the query's start, which
// keeps more digits than the foot of the origin. Returns 0 where it is not finite or has no normal.
export function placePlane(query: usize, nx: real, ny: real, offset: real): i32 {
  const q = queryAt(query);
  const length = sqrt<real>(nx * nx + ny * ny);
  makePlane(wall, nx / length, ny / length);
  const height = wall.nx0 * q.x + wall.ny0 * q.y - offset;
  pose.x = -height * wall.nx0;
  pose.y = -height * wall.ny0;
  pose.c = 1;
  pose.s = 0;
  return i32(length > 0 && isFinite<real>(length + height));
}

export function rayMeetsWall(query: usize): i32 {
  const q = queryAt(query);
  return i32(wall.kind == PLANE ? rayMeetsPlane(q, wall, pose) : rayMeets(q, wall, pose));
}

export function castMeetsWall(query: usize, shape: usize): i32 {
  return i32(castMeets(queryAt(query), changetype<Shape>(shape), wall, pose));
}

export function isNearWall(query: usize, shape: usize): i32 {
  const q = queryAt(query);
  const own = changetype<Shape>(shape);
  if (wall.kind == PLANE) measurePlane(q, own, wall, pose);
  else measure(q, own, wall, pose);
  return i32(isWithinReach(q, own));
}
