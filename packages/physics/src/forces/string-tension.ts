// The tension of an inextensible string from a fixed pivot: a pendulum.
//
//   T = F·n + m v_t²/r along -n when r ≥ (1 - 10⁻³) L, and never negative; else 0
//
//   F  force of all laws listed before this one, N    n  unit vector from the pivot to the body
//   v_t  speed across the string, m/s    r  distance from the pivot, m    L  length of the string, m
//
// It answers the forces before it: list it last. The radial acceleration is then exactly that of a circle, and the length
// drifts only by the integrator's error (Runge-Kutta 4 at a hundredth of the period: 10⁻⁸ a swing), and in single
// precision by rounding, some 10⁻⁴ in a minute. A string that goes slack is slack, but one that comes taut with a jerk
// stretches: that is an impulse, and a joint's work.
// Goldstein, Classical Mechanics, section 1.3. For some bodies only, wrap it in `restrictForce`.
// Cost: some 30 operations and two divisions a body.
import { defineLaw } from '../dynamics/define-law.ts';
import type { VectorInput } from '../errors/validate.ts';
import { select, vec3 } from '../laws/expression.ts';
import { scalar, vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { LENGTHS, PLACES } from './support/bounds.ts';

export interface StringOptions {
  /** Where it hangs, m; default the origin. */
  readonly pivot?: VectorInput;
  /** L, m. */
  readonly length: number;
}

const TAUT = 0.999;

const law = /* @__PURE__ */ defineLaw({
  name: 'string tension',
  formula: 'T = F·n + m v_t²/r',
  source: 'Goldstein, Classical Mechanics, section 1.3.',
  parameters: { pivot: vector('m', { default: {}, ...PLACES }), length: scalar('m', LENGTHS) },
  // All of it is in proportion to mass: T/m answers F/m. With r for the unit vector n, T/(m r) = (F·r/m + v_t²)/r².
  acceleration({ position, velocity, acceleration }, { pivot, length }) {
    const from = position.sub(pivot);
    const square = from.lengthSquared();
    const across = velocity.lengthSquared().sub(velocity.dot(from).square().div(square));
    const pull = acceleration.dot(from).add(across).div(square);
    const isTaut = square.greaterOrEqual(length.mul(TAUT).square());
    return select(isTaut.and(pull.greater(0)), from.mul(pull).negate(), vec3(0, 0, 0));
  },
});

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function stringTension(options: StringOptions): Force {
  return law(options);
}
