// The tension of an inextensible string from a fixed pivot: a pendulum.
//
//   T = F·n + m v_t²/r along -n when r ≥ (1 - 10⁻³) L, and never negative; else 0
//
//   F  force of all laws listed before this one, N    n  unit vector from the pivot to the body
//   v_t  speed across the string, m/s    r  distance from the pivot, m    L  length of the string, m
//
// It answers the forces before it: list it last. The radial acceleration is then exactly that of a circle, and the length
// drifts only by the integrator's error (Runge-Kutta 4 at a hundredth of the period: 10⁻⁸ a swing). A string that goes
// slack is slack, but one that comes taut with a jerk stretches: that is an impulse, and a joint's work.
// Goldstein, Classical Mechanics, section 1.3. For some bodies only, wrap it in `limited`.
// Cost: one square root, two divisions a body.
import { checkKeys, checkNumber, checkVector, type VectorInput } from '../faults/validate';
import { LENGTHS, PLACES } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';

export interface StringOptions {
  /** Where it hangs, m; default the origin. */
  readonly pivot?: VectorInput;
  /** L, m. */
  readonly length: number;
}

const TAUT = 0.999;

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function stringTension(options: StringOptions): Force {
  checkKeys(options, 'stringTension', ['pivot', 'length']);
  const pivot = checkVector(options.pivot ?? {}, 'stringTension.pivot', PLACES);
  const length = checkNumber(options.length, 'stringTension.length', LENGTHS);
  return {
    name: 'string tension',
    equation: 'T = F·n + m v_t²/r',
    parameters: { length: { unit: 'm', value: length } },
    reads: ['Position', 'Velocity', 'Mass'],
    local: true,
    timeless: true,
    accumulate(world, first, last) {
      const { x, y, z } = world.scratch.at.force;
      const pz = world.dimensions === 3 ? pivot.z : 0;
      lawKernels(world).stringTension(x, y, z, pivot.x, pivot.y, pz, length, TAUT, first, last);
    },
  };
}
