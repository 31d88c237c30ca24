import { checkLength } from './limits.ts';
import { makeShape } from './make-shape.ts';
import type { Shape } from './shape.ts';

/**
 * A rod with round ends, along the x axis of its body.
 * @param length distance of the centres of the two ends, m; the capsule is 2 `radius` longer
 * @param radius m
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE outside 1e-5 to 1e6 m
 */
export function capsule(length: number, radius: number): Shape {
  const half = 0.5 * checkLength(length, 'capsule: length');
  return makeShape('capsule', [-half, 0, half, 0], checkLength(radius, 'capsule: radius'));
}
