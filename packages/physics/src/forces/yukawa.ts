// A screened central force: Coulomb near the centre, nothing some screening lengths away.
//
//   U = q k e^(-r/λ)/r        F = q k e^(-r/λ) (1/r + 1/λ) r̂/r
//
//   q  charge (k in N m²/C) or mass (k in N m²/kg)    k  strength, negative attracts    λ  screening length, m
//
// Yukawa, Proc. Phys.-Math. Soc. Japan 17, 48 (1935); Debye and Hückel (1923) for charges in an electrolyte. At r = 0
// there is no direction and no force. Cost: one square root and one exponential, some 25 ns a body.
import { checkKeys, checkNumber } from '../faults/validate';
import { ANY, LENGTHS } from './bounds';
import { CENTRE_KEYS, type CentreOptions, centralForce, LAW, type LawParameters } from './central';
import { checkCoupling } from './coupling';
import type { Force } from './force';

export interface YukawaOptions extends CentreOptions {
  /** k; negative attracts. */
  readonly strength: number;
  /** Screening length λ, m. */
  readonly range: number;
  /** What the force is proportional to; default 'Charge'. */
  readonly couplesTo?: 'Mass' | 'Charge';
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function yukawa(options: YukawaOptions): Force {
  checkKeys(options, 'yukawa', ['strength', 'range', 'couplesTo', ...CENTRE_KEYS]);
  const strength = checkNumber(options.strength, 'yukawa.strength', ANY);
  const range = checkNumber(options.range, 'yukawa.range', LENGTHS);
  const couplesTo = checkCoupling(options.couplesTo ?? 'Charge', 'yukawa.couplesTo');
  const values: LawParameters = [strength, range, 0];
  return centralForce(
    {
      name: 'Yukawa force',
      equation: 'F = q k e^(-r/λ) (1/r + 1/λ) r̂/r',
      law: LAW.yukawa,
      couplesTo,
      parameters: {
        strength: { unit: couplesTo === 'Mass' ? 'N m²/kg' : 'N m²/C', value: strength },
        range: { unit: 'm', value: range },
      },
      values: () => values,
    },
    options,
    'yukawa',
  );
}
