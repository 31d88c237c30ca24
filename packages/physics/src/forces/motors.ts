// Motion driven by power: a car with its foot down.
//
//   F = P/v along the velocity, at most `maxForce`; from rest along `heading`
//
//   P  power, W, and the limit, N: the component Motor    v  speed, m/s
//
// So that dE/dt = P above the speed P/maxForce; below it wheels would spin. Negative power brakes, and at rest does
// nothing. With linear drag c: v² → P/c. Steady power is an idealisation of an engine with a perfect gearbox.
// Cost: one square root, four divisions a body.
import { checkKeys, checkVector, type VectorInput } from '../faults/validate';
import { PLACES } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { unit } from './lift';
import { shownVector } from './time-vector';

export interface MotorOptions {
  /** Where bodies at rest set off to; default +x. */
  readonly heading?: VectorInput;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function motors(options: MotorOptions = {}): Force {
  checkKeys(options, 'motors', ['heading']);
  const heading = unit(checkVector(options.heading ?? { x: 1 }, 'motors.heading', PLACES), 'motors.heading');
  return {
    name: 'motors',
    equation: 'F = min(P/v, F_max) v̂',
    parameters: shownVector('heading', '', heading),
    reads: ['Velocity', 'Motor'],
    local: true,
    timeless: true,
    accumulate(world, first, last) {
      if (world.internal.counts.Motor === 0) return;
      const { power, maxForce } = world.addresses.Motor;
      const { x, y, z } = world.scratch.at.force;
      const hz = world.dimensions === 3 ? heading.z : 0;
      lawKernels(world).motorForce(x, y, z, power, maxForce, heading.x, heading.y, hz, first, last);
    },
  };
}
