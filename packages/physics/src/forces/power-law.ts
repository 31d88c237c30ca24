// A central force that goes as any power of the distance.
//
//   F = q k rⁿ r̂        U = -q k rⁿ⁺¹/(n + 1), or -q k ln r for n = -1
//
//   q  mass (k in N m⁻ⁿ/kg) or charge (k in N m⁻ⁿ/C)    k  strength, negative attracts    n  any real exponent
//   r  distance from the centre, m
//
// n = 1 is a spring, n = -2 gravity; by Bertrand's theorem (1873) only these two close every bound orbit. Within
// `innerRadius`, and at r = 0, there is no force, and the potential is that at `innerRadius`.
// Goldstein, Classical Mechanics, 3rd ed., sections 3.5 and 3.6. Cost: one square root and one power, some 65 ns a body;
// 6 ns for n = 1 and n = -2.
import { checkKeys, checkNumber } from '../faults/validate';
import { ANY } from './bounds';
import { CENTRE_KEYS, type CentreOptions, centralForce, LAW, type LawParameters } from './central';
import { checkCoupling } from './coupling';
import type { Force } from './force';

export interface PowerLawOptions extends CentreOptions {
  /** k: force per unit of coupling at a distance of one metre; negative attracts. */
  readonly strength: number;
  /** n. */
  readonly exponent: number;
  /** Within it there is no force, m; default 0. */
  readonly innerRadius?: number;
  /** What the force is proportional to; default 'Mass'. */
  readonly couplesTo?: 'Mass' | 'Charge';
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function powerLaw(options: PowerLawOptions): Force {
  checkKeys(options, 'powerLaw', ['strength', 'exponent', 'innerRadius', 'couplesTo', ...CENTRE_KEYS]);
  const strength = checkNumber(options.strength, 'powerLaw.strength', ANY);
  const exponent = checkNumber(options.exponent, 'powerLaw.exponent', { min: -100, max: 100 });
  const inner = checkNumber(options.innerRadius ?? 0, 'powerLaw.innerRadius', { min: 0, max: 1e15 });
  const couplesTo = checkCoupling(options.couplesTo ?? 'Mass', 'powerLaw.couplesTo');
  const values: LawParameters = [strength, exponent, inner];
  return centralForce(
    {
      name: 'power law',
      equation: 'F = q k rⁿ r̂',
      law: LAW.powerLaw,
      couplesTo,
      parameters: {
        strength: { unit: couplesTo === 'Mass' ? 'N m⁻ⁿ/kg' : 'N m⁻ⁿ/C', value: strength },
        exponent: { unit: '', value: exponent },
        innerRadius: { unit: 'm', value: inner },
      },
      values: () => values,
    },
    options,
    'powerLaw',
  );
}
