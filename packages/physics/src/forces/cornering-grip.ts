// Cornering grip of tyres: the centripetal force that a car on a circle needs, limited by friction.
//
//   F = min(m v²/r, μ m g) towards the centre
//
//   v  speed, m/s    r  distance from the centre, m    μ  static friction coefficient    g  gravity, m/s²
//
// Up to v = √(μ g r) the car keeps its radius; at higher speed it slides outwards. The force acts on all bodies with
// mass: wrap it in `restrictForce` to select cars. It is lateral friction only: add `motors` and `quadraticDrag` for
// the rest. Feynman, Lectures on Physics I, section 12-2. Cost: one square root and two divisions per body.
import { defineLaw } from '../dynamics/define-law.ts';
import type { VectorInput } from '../errors/validate.ts';
import { select } from '../laws/expression.ts';
import { scalar, vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { NOT_NEGATIVE, POSITION_BOUNDS } from './support/bounds.ts';
import { STANDARD_GRAVITY } from './support/standard-gravity.ts';

/** Options of `corneringGrip`. */
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
    centre: vector('m', { default: {}, ...POSITION_BOUNDS }),
    friction: scalar('', { min: 0, max: 100 }),
    gravity: scalar('m/s²', { default: STANDARD_GRAVITY, ...NOT_NEGATIVE }),
  },
  acceleration({ position, velocity }, { centre, friction, gravity }) {
    const offset = position.sub(centre);
    const r = offset.length();
    const acceleration = velocity.lengthSquared().div(r).min(friction.mul(gravity));
    return offset.mul(select(r.greater(0), acceleration.div(r).negate(), 0));
  },
});

/**
 * The centripetal force that keeps a car on a circle, limited by friction: F = min(m v²/r, μ m g) towards the centre,
 * N, on every body with mass.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function corneringGrip(options: CorneringGripOptions): Force {
  return law(options);
}
