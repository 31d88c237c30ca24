// A whirl that throws out what is in its core and draws in what is outside.
//
//   r ≤ r₀  F = m k r        U = -m k r²/2
//   r > r₀  F = -m k (r₀/r)⁴ r    U = -m k r₀⁴/(2r²)
//
//   m  mass, kg    k  strength, 1/s² (the square of the core's angular speed)    r₀  radius of the core, m
//
// The core turns as a solid body, and its centrifugal force wins; outside, the pressure of a free vortex (speed 1/r)
// draws inwards. So at r₀ the force is m k r₀ on either side but jumps from outward to inward: bodies gather on the rim,
// and a step that crosses it errs by the first order. The potential is continuous. For the flow itself, and drag in it,
// give `turbulentDrag` or `quadraticDrag` a wind. Cost: one square root, one division a body.
import { checkKeys, checkNumber } from '../faults/validate';
import { ANY, LENGTHS } from './bounds';
import { CENTRE_KEYS, type CentreOptions, centralForce, LAW, type LawParameters } from './central';
import type { Force } from './force';

export interface VortexOptions extends CentreOptions {
  /** k, 1/s². */
  readonly strength: number;
  /** Radius r₀ of the core, m. */
  readonly radius: number;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function vortex(options: VortexOptions): Force {
  checkKeys(options, 'vortex', ['strength', 'radius', ...CENTRE_KEYS]);
  const strength = checkNumber(options.strength, 'vortex.strength', ANY);
  const radius = checkNumber(options.radius, 'vortex.radius', LENGTHS);
  const values: LawParameters = [strength, radius, 0];
  return centralForce(
    {
      name: 'vortex',
      equation: 'F = m k r within r₀, -m k (r₀/r)⁴ r beyond',
      law: LAW.vortex,
      couplesTo: 'Mass',
      parameters: { strength: { unit: '1/s²', value: strength }, radius: { unit: 'm', value: radius } },
      values: () => values,
    },
    options,
    'vortex',
  );
}
