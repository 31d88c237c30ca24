// Propulsion at constant power, as of a car at full throttle.
//
//   F = P/v along the velocity, at most `maxForce`; from rest along `heading`
//
//   P  power, W, and maximum force, N: the component Motor    v  speed, m/s
//
// So dE/dt = P above the speed P/maxForce, below which wheels would spin. Negative power brakes, and has no effect at
// rest. With linear drag c: v² → P/c. Constant power idealises an engine with a perfect gearbox. Cost: one square
// root and four divisions per body.
import { Motor } from '../components/propulsion.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys, checkVector, type VectorInput } from '../errors/validate.ts';
import { select } from '../laws/expression.ts';
import { vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { POSITION_BOUNDS } from './support/bounds.ts';
import { unit } from './support/unit-vector.ts';

/** Options of `motors`. */
export interface MotorOptions {
  /** Direction in which bodies at rest start; default +x. */
  readonly heading?: VectorInput;
}

const law = /* @__PURE__ */ defineLaw({
  name: 'motors',
  formula: 'F = min(P/v, F_max) v̂',
  reads: { motor: Motor },
  parameters: { heading: vector('') },
  force({ velocity, motor: { power, maxForce } }, { heading }) {
    const speed = velocity.length();
    const magnitude = power.div(speed).min(maxForce).max(maxForce.negate());
    // A brake has no effect at rest.
    const fromRest = select(power.greater(0), maxForce, 0);
    return select(speed.greater(0), velocity.div(speed).mul(magnitude), heading.mul(fromRest));
  },
});

/**
 * Propulsion at constant power, as of a car at full throttle: F = P/v along the velocity, N, at most the maximum
 * force, from the component `motor`.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function motors(options: MotorOptions = {}): Force {
  checkKeys(options, 'motors', ['heading']);
  const heading = checkVector(options.heading ?? { x: 1 }, 'motors.heading', POSITION_BOUNDS);
  return law({ heading: unit(heading, 'motors.heading') });
}
