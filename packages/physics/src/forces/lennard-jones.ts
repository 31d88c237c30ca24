// Attraction at a distance and hard repulsion near a fixed centre, as between two neutral atoms.
//
//   U = 4 q ε ((σ/r)¹² - (σ/r)⁶)        F = 24 q ε (2 (σ/r)¹² - (σ/r)⁶) r̂/r
//
//   q  mass (ε in J/kg) or charge (ε in J/C)    ε  depth    σ  distance of zero energy, m; the minimum is at 2^(1/6) σ
//
// Lennard-Jones, Proc. Phys. Soc. 43, 461 (1931). The force grows as r⁻¹³: a body thrown at the centre needs short
// steps, and in f32 distances under σ/500 overflow. Cost: one square root, two divisions a body.
import { checkKeys, checkNumber } from '../faults/validate';
import { LENGTHS, NOT_NEGATIVE } from './bounds';
import { CENTRE_KEYS, type CentreOptions, centralForce, LAW, type LawParameters } from './central';
import { checkCoupling } from './coupling';
import type { Force } from './force';

export interface LennardJonesOptions extends CentreOptions {
  /** ε: depth of the well per unit of coupling. */
  readonly depth: number;
  /** σ: distance at which the energy is zero, m. */
  readonly diameter: number;
  /** What the force is proportional to; default 'Mass'. */
  readonly couplesTo?: 'Mass' | 'Charge';
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function lennardJones(options: LennardJonesOptions): Force {
  checkKeys(options, 'lennardJones', ['depth', 'diameter', 'couplesTo', ...CENTRE_KEYS]);
  const depth = checkNumber(options.depth, 'lennardJones.depth', NOT_NEGATIVE);
  const diameter = checkNumber(options.diameter, 'lennardJones.diameter', LENGTHS);
  const couplesTo = checkCoupling(options.couplesTo ?? 'Mass', 'lennardJones.couplesTo');
  const values: LawParameters = [depth, diameter, 0];
  return centralForce(
    {
      name: 'Lennard-Jones force',
      equation: 'F = 24 q ε (2 (σ/r)¹² - (σ/r)⁶) r̂/r',
      law: LAW.lennardJones,
      couplesTo,
      parameters: {
        depth: { unit: couplesTo === 'Mass' ? 'J/kg' : 'J/C', value: depth },
        diameter: { unit: 'm', value: diameter },
      },
      values: () => values,
    },
    options,
    'lennardJones',
  );
}
