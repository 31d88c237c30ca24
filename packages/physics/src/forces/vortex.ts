// A vortex that pushes out bodies in its core and draws in bodies outside.
//
//   r ≤ r₀  F = m k r        U = -m k r²/2
//   r > r₀  F = -m k (r₀/r)⁴ r    U = -m k r₀⁴/(2r²)
//
//   m  mass, kg    k  strength, 1/s² (the square of the core's angular speed)    r₀  radius of the core, m
//
// The core rotates as a rigid body, and its centrifugal force dominates; outside, the pressure gradient of a free
// vortex (speed 1/r) acts inwards. At r₀ the force is m k r₀ on both sides but flips from outward to inward: bodies
// gather on the rim, and a step across it has a first-order error. The potential is continuous. For the flow itself,
// and drag in it, pass a wind to `turbulentDrag` or `quadraticDrag`. Cost: one square root, one division and 17 more
// operations per body.
import { select } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { ANY, LENGTH_BOUNDS } from './support/bounds.ts';
import { type CentralLaw, type CentreOptions, centralForce } from './support/central-force.ts';

/** Options of `vortex`. */
export interface VortexOptions extends CentreOptions {
  /** Strength k, 1/s². */
  readonly strength: number;
  /** Radius r₀ of the core, m. */
  readonly radius: number;
}

const parameters = { strength: scalar('1/s²', ANY), radius: scalar('m', LENGTH_BOUNDS) };

const LAW: CentralLaw<typeof parameters> = {
  name: 'vortex',
  formula: 'F = m k r within r₀, -m k (r₀/r)⁴ r beyond',
  parameters,
  field(r, { strength, radius }) {
    const distance = r.length();
    const square = radius.div(distance.max(radius)).square();
    const outside = strength.mul(square).mul(square).negate();
    return r.mul(select(distance.lessOrEqual(radius), strength, outside));
  },
  energy(r, { strength, radius }) {
    const distance = r.length();
    const outside = radius.mul(radius.div(distance.max(radius)));
    return strength.mul(distance.min(outside).square()).div(2).negate();
  },
};

/**
 * A vortex that pushes bodies out of its core, F = m k r, N, and draws in those outside, F = -m k (r₀/r)⁴ r: they
 * gather on its rim.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function vortex(options: VortexOptions): Force {
  return centralForce(LAW, 'Mass', options);
}
