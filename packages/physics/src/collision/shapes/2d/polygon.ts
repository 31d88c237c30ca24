import { checkKeys } from '../../../errors/validate.ts';
import type { RoundingOptions } from './box.ts';
import { checkOutline } from './convex-outline.ts';
import { checkRounding } from './limits.ts';
import { makeShape } from './make-shape.ts';
import type { PointInput, Shape } from './shape.ts';

/**
 * A convex polygon of 3 to 8 corners, in either direction around. Its centroid becomes the origin of the body's frame,
 * and the value's `centre` says where that was: a body at `centre` has its corners where they were given. `rounding`
 * moves the outline outward by this distance and rounds it there.
 * @param points corners in order around the outline, m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE for outlines that are concave, cross themselves, have
 *   three corners on a line or neighbours closer than 1e-5 m, or reach beyond 1e6 m
 */
export function polygon(points: readonly PointInput[], options: RoundingOptions = {}): Shape {
  checkKeys(options, 'polygon', ['rounding']);
  const rounding = checkRounding(options.rounding, 'polygon: rounding');
  return makeShape('polygon', checkOutline(points, 'polygon'), rounding);
}
