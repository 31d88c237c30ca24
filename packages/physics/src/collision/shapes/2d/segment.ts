import { PhysicsError } from '../../../errors/physics-error.ts';
import { checkPoint } from './convex-outline.ts';
import { MIN_LENGTH } from './limits.ts';
import { makeShape } from './make-shape.ts';
import { lengthOf, type PointInput, type Shape } from './shape.ts';

/**
 * A line without thickness that bodies meet from both sides: for floors and walls, because it has no area and therefore
 * no mass. The value's `centre` is the middle of the line: a body at this position has the ends where they were given.
 * @param a m
 * @param b m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE for coordinates beyond 1e6 m and ends closer than 1e-5 m
 */
export function segment(a: PointInput, b: PointInput): Shape {
  const [start, end] = [checkPoint(a, 'segment: a'), checkPoint(b, 'segment: b')];
  const length = lengthOf(end.x - start.x, end.y - start.y);
  if (length < MIN_LENGTH) {
    throw new PhysicsError('E_RANGE', `segment: the ends are ${length} m apart.`, {
      field: 'segment: b',
      value: b,
      hint: `They must be at least ${MIN_LENGTH} m apart.`,
    });
  }
  return makeShape('segment', [start.x, start.y, end.x, end.y], 0);
}
