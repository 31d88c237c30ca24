import { checkLength } from './limits.ts';
import { makeShape } from './make-shape.ts';
import type { Shape } from './shape.ts';

/**
 * The shape of a disc about the centre of its body.
 * @param radius m, 1e-5 to 1e6
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function circle(radius: number): Shape {
  return makeShape('circle', [0, 0], checkLength(radius, 'circle: radius'));
}
