// Tyres on a bend: the force towards the centre that a car on a circle needs, as far as friction can give it.
//
//   F = min(m v²/r, μ m g) towards the centre
//
//   v  speed, m/s    r  distance from the centre, m    μ  static friction coefficient    g  gravity, m/s²
//
// Up to v = √(μ g r) the car keeps its radius; faster, it slides outwards. It steers whatever comes near: for the cars
// alone, wrap it in `restrictForce`. Sideways friction only: add `motors` and `quadraticDrag` for the rest.
// Feynman, Lectures on Physics I, section 12-2. Cost: one square root, two divisions a body.
import { defineLaw } from '../dynamics/define-law.ts';
import type { VectorInput } from '../errors/validate.ts';
import { select } from '../laws/expression.ts';
import { scalar, vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { NOT_NEGATIVE, PLACES } from './support/bounds.ts';
import { STANDARD_GRAVITY } from './support/standard-gravity.ts';

export interface CorneringGripOptions {
  /** Centre of the bend, m; default the origin. */
  readonly centre?: VectorInput;
  /** μ. */
  readonly friction: number;
  /** g, m/s²; default standard gravity. */
  readonly gravity?: number;
}

const law = /* @__PURE__ */ defineLaw({
  name: 'grip on a bend',
  formula: 'F = min(m v²/r, μ m g) towards the centre',
  source: 'Feynman, Lectures on Physics I, section 12-2.',
  parameters: {
    centre: vector('m', { default: {}, ...PLACES }),
    friction: scalar('', { min: 0, max: 100 }),
    gravity: scalar('m/s²', { default: STANDARD_GRAVITY, ...NOT_NEGATIVE }),
  },
  acceleration({ position, velocity }, { centre, friction, gravity }) {
    const from = position.sub(centre);
    const r = from.length();
    const size = velocity.lengthSquared().div(r).min(friction.mul(gravity));
    return from.mul(select(r.greater(0), size.div(r).negate(), 0));
  },
});

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function corneringGrip(options: CorneringGripOptions): Force {
  return law(options);
}
