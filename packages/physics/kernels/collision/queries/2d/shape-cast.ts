// Where a shape that moves along a line first meets bodies.
import { RelativePose } from '../../narrow-phase/2d/relative-pose';
import { motionOfA, motionOfB, stay } from '../../narrow-phase/2d/shape-motion';
import { Sweep, timeOfImpact } from '../../narrow-phase/2d/time-of-impact';
import { Shape } from '../../shapes/2d/shape';
import { shapeOf } from '../../shapes/2d/shape-pool';
import { BodyQuery, nextNear, poseFromQuery, queryAt, spare } from './body-query';

// Surfaces this far apart have met, m.
const TARGET: real = 1e-4;

const sweep = changetype<Sweep>(memory.data(offsetof<Sweep>() + 8, 8));

// Returns the first body from `row` on that the shape at this address meets within the limit, 0 if there is none.
export function nextShapeHit(query: usize, shape: usize, row: i32): i32 {
  const q = queryAt(query);
  for (let r = nextNear(q, row); r > 0; r = nextNear(q, r + 1)) {
    if (castMeets(q, changetype<Shape>(shape), shapeOf(r, spare()), poseFromQuery(q, r))) return r;
  }
  return 0;
}

// The pose is that of `other` from the start of the query.
export function castMeets(q: BodyQuery, own: Shape, other: Shape, pose: RelativePose): bool {
  stay(motionOfA(sweep), pose.x, pose.y, pose.c, pose.s);
  stay(motionOfB(sweep), 0, 0, q.c, q.s);
  sweep.endBx = q.limit * q.dx;
  sweep.endBy = q.limit * q.dy;
  sweep.target = TARGET;
  timeOfImpact(sweep, other, own);
  if (sweep.isHit == 0) return false;
  q.fraction = sweep.fraction * q.limit;
  q.nx = sweep.nx;
  q.ny = sweep.ny;
  q.pointX = q.x + sweep.x;
  q.pointY = q.y + sweep.y;
  return true;
}
