// Motion driven by power: a car with its foot down.
//
//   F = P/v along the velocity, at most `maxForce`; from rest along `heading`
//
//   P  power, W, and the limit, N: the component Motor    v  speed, m/s
//
// So that dE/dt = P above the speed P/maxForce; below it wheels would spin. Negative power brakes, and at rest does
// nothing. With linear drag c: v² → P/c. Steady power is an idealisation of an engine with a perfect gearbox.
// Cost: one square root, four divisions a body.
import { Motor } from '../components/propulsion.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { checkKeys, checkVector, type VectorInput } from '../errors/validate.ts';
import { select } from '../laws/expression.ts';
import { vector } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { PLACES } from './support/bounds.ts';
import { unit } from './support/unit-vector.ts';

export interface MotorOptions {
  /** Where bodies at rest set off to; default +x. */
  readonly heading?: VectorInput;
}

const law = /* @__PURE__ */ defineLaw({
  name: 'motors',
  formula: 'F = min(P/v, F_max) v̂',
  reads: { motor: Motor },
  parameters: { heading: vector('') },
  force({ velocity, motor: { power, maxForce } }, { heading }) {
    const speed = velocity.length();
    const size = power.div(speed).min(maxForce).max(maxForce.negate());
    // A brake has nothing to act against at rest.
    const fromRest = select(power.greater(0), maxForce, 0);
    return select(speed.greater(0), velocity.div(speed).mul(size), heading.mul(fromRest));
  },
});

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function motors(options: MotorOptions = {}): Force {
  checkKeys(options, 'motors', ['heading']);
  const heading = checkVector(options.heading ?? { x: 1 }, 'motors.heading', PLACES);
  return law({ heading: unit(heading, 'motors.heading') });
}
