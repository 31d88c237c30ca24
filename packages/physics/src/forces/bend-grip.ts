// Tyres on a bend: the force towards the centre that a car on a circle needs, as far as friction can give it.
//
//   F = min(m v²/r, μ m g) towards the centre
//
//   v  speed, m/s    r  distance from the centre, m    μ  static friction coefficient    g  gravity, m/s²
//
// Up to v = √(μ g r) the car keeps its radius; faster, it slides outwards. It steers whatever comes near: for the cars
// alone, wrap it in `limited`. Sideways friction only: add `motors` and `quadraticDrag` for the rest.
// Feynman, Lectures on Physics I, section 12-2. Cost: one square root, two divisions a body.
import { checkKeys, checkNumber, checkVector, type VectorInput } from '../faults/validate';
import { NOT_NEGATIVE, PLACES } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { STANDARD_GRAVITY } from './uniform-gravity';

export interface BendOptions {
  /** Centre of the bend, m; default the origin. */
  readonly centre?: VectorInput;
  /** μ. */
  readonly friction: number;
  /** g, m/s²; default standard gravity. */
  readonly gravity?: number;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function bendGrip(options: BendOptions): Force {
  checkKeys(options, 'bendGrip', ['centre', 'friction', 'gravity']);
  const centre = checkVector(options.centre ?? {}, 'bendGrip.centre', PLACES);
  const friction = checkNumber(options.friction, 'bendGrip.friction', { min: 0, max: 100 });
  const gravity = checkNumber(options.gravity ?? STANDARD_GRAVITY, 'bendGrip.gravity', NOT_NEGATIVE);
  const grip = friction * gravity;
  return {
    name: 'grip on a bend',
    equation: 'F = min(m v²/r, μ m g) towards the centre',
    parameters: { friction: { unit: '', value: friction }, gravity: { unit: 'm/s²', value: gravity } },
    reads: ['Position', 'Velocity', 'Mass'],
    local: true,
    timeless: true,
    accumulate(world, first, last) {
      const { x, y, z } = world.scratch.at.force;
      const cz = world.dimensions === 3 ? centre.z : 0;
      lawKernels(world).bendForce(x, y, z, centre.x, centre.y, cz, grip, first, last);
    },
  };
}
