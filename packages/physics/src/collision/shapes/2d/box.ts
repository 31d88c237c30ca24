import { PhysicsError } from '../../../errors/physics-error.ts';
import { checkKeys } from '../../../errors/validate.ts';
import { checkLength, checkRounding, MIN_LENGTH } from './limits.ts';
import { makeShape } from './make-shape.ts';
import type { Shape } from './shape.ts';

/** Options of boxes and polygons. */
export interface RoundingOptions {
  /** Radius of the corners, m; 0, the default, leaves them sharp. */
  readonly rounding?: number;
}

/**
 * A rectangle, `width` along the x axis of its body and `height` along y. Rounded corners lie within this size.
 * @param width m
 * @param height m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_UNKNOWN, E_RANGE outside 1e-5 to 1e6 m or when corners are rounder than the
 *   box is wide
 */
export function box(width: number, height: number, options: RoundingOptions = {}): Shape {
  checkKeys(options, 'box', ['rounding']);
  const radius = checkRounding(options.rounding, 'box: rounding');
  const x = 0.5 * checkLength(width, 'box: width') - radius;
  const y = 0.5 * checkLength(height, 'box: height') - radius;
  if (Math.min(x, y) < 0.5 * MIN_LENGTH) {
    throw new PhysicsError('E_RANGE', `box: rounding is ${radius} m in a box of ${width} m by ${height} m.`, {
      field: 'box: rounding',
      value: radius,
      hint: `It must be less than half of the shorter side, of which ${MIN_LENGTH} m must be left; for round ends use capsule(length, radius).`,
    });
  }
  return makeShape('polygon', [-x, -y, x, -y, x, y, -x, y], radius);
}
