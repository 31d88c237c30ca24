// Attraction at a distance and strong repulsion near a fixed centre, as between two neutral atoms.
//
//   U = 4 q ε ((σ/r)¹² - (σ/r)⁶)        F = 24 q ε (2 (σ/r)¹² - (σ/r)⁶) r̂/r
//
//   q  mass (ε in J/kg) or charge (ε in J/C)    ε  depth    σ  distance of zero energy, m; the minimum is at 2^(1/6) σ
//
// Lennard-Jones, Proc. Phys. Soc. 43, 461 (1931). The force grows as r⁻¹³: a head-on collision needs short steps, and
// in f32 distances below σ/500 overflow. Cost: one square root, one division and 22 more operations per body.
import { checkKeys } from '../errors/validate.ts';
import type { Scalar, Vector } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { LENGTH_BOUNDS, NOT_NEGATIVE } from './support/bounds.ts';
import { CENTRE_KEYS, type CentreOptions, centralForce, inverseWhere } from './support/central-force.ts';
import { checkCoupling } from './support/coupling.ts';

/** Options of `lennardJones`. */
export interface LennardJonesOptions extends CentreOptions {
  /** Depth ε of the well per unit of coupling. */
  readonly depth: number;
  /** Distance σ of zero energy, m. */
  readonly diameter: number;
  /** The component that the force is proportional to; default 'Mass'. */
  readonly couplesTo?: 'Mass' | 'Charge';
}

/**
 * Attraction to a fixed centre at a distance and strong repulsion near it, as between neutral atoms: F = 24 q ε (2
 * (σ/r)¹² - (σ/r)⁶) r̂/r, N, on bodies with mass or charge q. Lennard-Jones (1931).
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function lennardJones(options: LennardJonesOptions): Force {
  checkKeys(options, 'lennardJones', ['depth', 'diameter', 'couplesTo', ...CENTRE_KEYS]);
  const { couplesTo = 'Mass', ...given } = options;
  checkCoupling(couplesTo, 'lennardJones.couplesTo');
  return centralForce(
    {
      name: 'Lennard-Jones force',
      formula: 'F = 24 q ε (2 (σ/r)¹² - (σ/r)⁶) r̂/r',
      source: 'Lennard-Jones, Proc. Phys. Soc. 43, 461 (1931).',
      parameters: {
        depth: scalar(couplesTo === 'Mass' ? 'J/kg' : 'J/C', NOT_NEGATIVE),
        diameter: scalar('m', LENGTH_BOUNDS),
      },
      field(r, { depth, diameter }) {
        const { inverse, sixth } = powersOf(r, diameter);
        const magnitude = depth.mul(24).mul(sixth).mul(sixth.mul(2).sub(1));
        return r.mul(inverse).mul(magnitude.mul(inverse));
      },
      energy(r, { depth, diameter }) {
        const { sixth } = powersOf(r, diameter);
        return depth.mul(4).mul(sixth).mul(sixth.sub(1));
      },
    },
    couplesTo,
    given,
  );
}

/** Returns 1/r and (σ/r)⁶, both 0 at r = 0. */
function powersOf(r: Vector, diameter: Scalar): { readonly inverse: Scalar; readonly sixth: Scalar } {
  const distance = r.length();
  const inverse = inverseWhere(distance.greater(0), distance);
  const square = diameter.mul(inverse).square();
  return { inverse, sixth: square.mul(square).mul(square) };
}
