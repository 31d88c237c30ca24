// A central force proportional to a power of the distance.
//
//   F = q k rⁿ r̂        U = -q k rⁿ⁺¹/(n + 1), or -q k ln r for n = -1
//
//   q  mass (k in N m⁻ⁿ/kg) or charge (k in N m⁻ⁿ/C)    k  strength, negative attracts    n  any real exponent
//   r  distance from the centre, m
//
// n = 1 is a spring, n = -2 gravity; by Bertrand's theorem (1873) all bound orbits are closed only for these two.
// Within `innerRadius`, and at r = 0, there is no force, and the potential is that at `innerRadius`. In f32 rⁿ must
// be within 10⁻³⁸ to 10³⁸; for n of 1 and -2 only the product with k must be. Goldstein, Classical Mechanics, 3rd
// ed., sections 3.5 and 3.6. Cost: one square root, one division and 15 more operations per body, and some products
// more if n is whole or half and at most 8, else a power; n = 1 without an inner radius takes two operations per axis.
import { checkKeys, checkNumber } from '../errors/validate.ts';
import { type Scalar, type ScalarInput, select, type Vector } from '../laws/expression.ts';
import { isShortPower } from '../laws/lower-power.ts';
import { scalar } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { ANY } from './support/bounds.ts';
import { CENTRE_KEYS, type CentreOptions, centralForce, inverseWhere } from './support/central-force.ts';
import { checkCoupling } from './support/coupling.ts';

/** Options of `powerLaw`. */
export interface PowerLawOptions extends CentreOptions {
  /** Force k per unit of coupling at a distance of one metre; negative attracts. */
  readonly strength: number;
  /** Exponent n. */
  readonly exponent: number;
  /** Radius within which there is no force, m; default 0. */
  readonly innerRadius?: number;
  /** The component that the force is proportional to; default 'Mass'. */
  readonly couplesTo?: 'Mass' | 'Charge';
}

const EXPONENTS = { min: -100, max: 100 };

/**
 * A central force proportional to a power of the distance: F = q k rⁿ r̂, N, on bodies with mass or charge q; n = 1 is
 * a spring, n = -2 gravity.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function powerLaw(options: PowerLawOptions): Force {
  checkKeys(options, 'powerLaw', ['strength', 'exponent', 'innerRadius', 'couplesTo', ...CENTRE_KEYS]);
  const { couplesTo = 'Mass', ...given } = options;
  checkCoupling(couplesTo, 'powerLaw.couplesTo');
  const n = checkNumber(options.exponent, 'powerLaw.exponent', EXPONENTS);
  const parameters = {
    strength: scalar(couplesTo === 'Mass' ? 'N m⁻ⁿ/kg' : 'N m⁻ⁿ/C', ANY),
    exponent: scalar('', EXPONENTS),
    innerRadius: scalar('m', { default: 0, min: 0, max: 1e15 }),
  };
  const [name, formula, source] = ['power law', 'F = q k rⁿ r̂', 'Goldstein, Classical Mechanics, 3.5 and 3.6.'];
  const field = fieldOf(n, options.innerRadius === undefined || options.innerRadius === 0);
  return centralForce({ name, formula, source, parameters, field, energy: energyOf(n) }, couplesTo, given);
}

interface Symbols {
  readonly strength: Scalar;
  readonly exponent: Scalar;
  readonly innerRadius: Scalar;
}

/** The exponent as a constant where that makes the power a product; else as a parameter, so that laws share their code. */
function exponentOf(n: number, exponent: Scalar): ScalarInput {
  return isShortPower(n) ? n : exponent;
}

/** The exponents 1 and -2 take fewer operations than the general form, and have a wider range in f32. */
function fieldOf(n: number, reachesCentre: boolean): (r: Vector, symbols: Symbols) => Vector {
  if (n === 1 && reachesCentre) return (r, { strength }) => r.mul(strength);
  return (r, { strength, exponent, innerRadius }) => {
    const distance = r.length();
    const isOutside = distance.greater(innerRadius);
    if (n === 1) return r.mul(select(isOutside, strength, 0));
    const inverse = inverseWhere(isOutside, distance);
    const magnitude =
      n === -2
        ? strength.mul(inverse).mul(inverse)
        : select(isOutside, strength.mul(distance.pow(exponentOf(n, exponent))), 0);
    return r.mul(inverse).mul(magnitude);
  };
}

function energyOf(n: number): (r: Vector, symbols: Symbols) => Scalar {
  return (r, { strength, exponent, innerRadius }) => {
    const distance = r.length().max(innerRadius);
    const magnitude = n === -1 ? distance.log() : distance.pow(exponentOf(n + 1, exponent.add(1))).div(exponent.add(1));
    // At r = 0, where the potential may be infinite, it is set to 0.
    return select(distance.greater(0), strength.mul(magnitude), 0).negate();
  };
}
