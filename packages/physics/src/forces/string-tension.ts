// The tension of an inextensible string from a fixed pivot: a pendulum.
//
//   T = F·n + m v_t²/r along -n when r ≥ (1 - 10⁻³) L, and never negative; else 0
//
//   F  force of all laws listed before this one, N    n  unit vector from the pivot to the body
//   v_t  speed perpendicular to the string, m/s    r  distance from the pivot, m    L  length of the string, m
//
// It reacts to the forces before it, so list it last. The radial acceleration is exactly that of a circle, so the
// length drifts only by the integrator's error (Runge-Kutta 4 at 100 steps per period: 10⁻⁸ per swing), and in single
// precision by rounding, about 10⁻⁴ in a minute. A string may go slack, but a string that becomes taut with a jerk
// stretches: the impulse needs a joint or `xpbd`. Goldstein, Classical Mechanics, section 1.3. To select bodies, wrap
// it in `restrictForce`. Cost: about 30 operations and two divisions per body.
import { defineLaw } from '../dynamics/define-law.ts';
import type { VectorInput } from '../errors/validate.ts';
import { select, vec3 } from '../laws/expression.ts';
import { scalar, vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { LENGTH_BOUNDS, POSITION_BOUNDS } from './support/bounds.ts';

export interface StringOptions {
  /** Position of the pivot, m; default the origin. */
  readonly pivot?: VectorInput;
  /** Length L, m. */
  readonly length: number;
}

const TAUT_RATIO = 0.999;

const law = /* @__PURE__ */ defineLaw({
  name: 'string tension',
  formula: 'T = F·n + m v_t²/r',
  source: 'Goldstein, Classical Mechanics, section 1.3.',
  parameters: { pivot: vector('m', { default: {}, ...POSITION_BOUNDS }), length: scalar('m', LENGTH_BOUNDS) },
  // The law is proportional to mass: T/m reacts to F/m. With the vector r for the unit vector n, T/(m r) = (F·r/m +
  // v_t²)/r².
  acceleration({ position, velocity, acceleration }, { pivot, length }) {
    const offset = position.sub(pivot);
    const square = offset.lengthSquared();
    const tangentialSquare = velocity.lengthSquared().sub(velocity.dot(offset).square().div(square));
    const tension = acceleration.dot(offset).add(tangentialSquare).div(square);
    const isTaut = square.greaterOrEqual(length.mul(TAUT_RATIO).square());
    return select(isTaut.and(tension.greater(0)), offset.mul(tension).negate(), vec3(0, 0, 0));
  },
});

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function stringTension(options: StringOptions): Force {
  return law(options);
}
