// A screened central force: Coulomb near the centre, negligible beyond several screening lengths.
//
//   U = q k e^(-r/λ)/r        F = q k e^(-r/λ) (1/r + 1/λ) r̂/r
//
//   q  charge (k in N m²/C) or mass (k in N m²/kg)    k  strength, negative attracts    λ  screening length, m
//
// Yukawa, Proc. Phys.-Math. Soc. Japan 17, 48 (1935); Debye and Hückel (1923) for charges in an electrolyte. At r = 0
// the force is zero. Cost: one square root, one exponential, two divisions and 17 more operations per body.
import { checkKeys } from '../errors/validate.ts';
import { constant, type Scalar, type Vector } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { ANY, LENGTH_BOUNDS } from './support/bounds.ts';
import { CENTRE_KEYS, type CentreOptions, centralForce, inverseWhere } from './support/central-force.ts';
import { checkCoupling } from './support/coupling.ts';

/** Options of `yukawa`. */
export interface YukawaOptions extends CentreOptions {
  /** Strength k; negative attracts. */
  readonly strength: number;
  /** Screening length λ, m. */
  readonly range: number;
  /** The component that the force is proportional to; default 'Charge'. */
  readonly couplesTo?: 'Mass' | 'Charge';
}

/**
 * A screened central force: F = q k e^(-r/λ) (1/r + 1/λ) r̂/r, N, on bodies with charge or mass q; negligible beyond
 * some screening lengths λ.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function yukawa(options: YukawaOptions): Force {
  checkKeys(options, 'yukawa', ['strength', 'range', 'couplesTo', ...CENTRE_KEYS]);
  const { couplesTo = 'Charge', ...given } = options;
  checkCoupling(couplesTo, 'yukawa.couplesTo');
  return centralForce(
    {
      name: 'Yukawa force',
      formula: 'F = q k e^(-r/λ) (1/r + 1/λ) r̂/r',
      source: 'Yukawa, Proc. Phys.-Math. Soc. Japan 17, 48 (1935).',
      parameters: {
        strength: scalar(couplesTo === 'Mass' ? 'N m²/kg' : 'N m²/C', ANY),
        range: scalar('m', LENGTH_BOUNDS),
      },
      field(r, { strength, range }) {
        const { screened, inverse } = termsOf(r, strength, range);
        return r.mul(inverse).mul(screened.mul(inverse.add(constant(1).div(range))).mul(inverse));
      },
      energy(r, { strength, range }) {
        const { screened, inverse } = termsOf(r, strength, range);
        return screened.mul(inverse);
      },
    },
    couplesTo,
    given,
  );
}

function termsOf(r: Vector, strength: Scalar, range: Scalar): { readonly screened: Scalar; readonly inverse: Scalar } {
  const distance = r.length();
  const screened = strength.mul(distance.div(range).negate().exp());
  return { screened, inverse: inverseWhere(distance.greater(0), distance) };
}
