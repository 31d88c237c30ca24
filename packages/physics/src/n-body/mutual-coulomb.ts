// The electrostatic force between all charges.
//
//   F_i = -Σ_j k q_i q_j (r_j - r_i) / (r² + ε²)^(3/2)       U = Σ_pairs k q_i q_j / √(r² + ε²)
//   F_i = -Σ_j k q_i q_j (r_j - r_i) / (r² + ε²)             U = -Σ_pairs k q_i q_j ln √(r² + ε²)   (law 1/r)
//
//   k  Coulomb constant, N m²/C² (N m/C² for the law 1/r)      q  charge, C: equal signs repel
//
// Valid for charges at rest or slow compared with light, in vacuum. A charge without Mass exerts forces and stays
// fixed. The tree's cells have dipoles, which do not vanish for mixed signs (the centre is that of the absolute
// charges). In matter that is neutral on average the far fields cancel, and the error is relative to the remainder: the
// tree then opens more cells and gains less than for gravity. Source: Coulomb 1785; the tree is that of
// mutual-gravity.ts. Cost: that of mutual-gravity.ts.
import { checkNumber } from '../errors/validate.ts';
import { COULOMB_CONSTANT } from '../forces/fixed-charges.ts';
import { checkMutualOptions, createMutualForce, type MutualForce, type MutualOptions } from './mutual-force.ts';

/** Options of `mutualCoulomb`. */
export interface MutualCoulombOptions extends MutualOptions {
  /** Default 8.9875517862e9 N m²/C². */
  readonly k?: number;
}

/**
 * Creates the electrostatic force between all bodies with Charge.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function mutualCoulomb(options: MutualCoulombOptions = {}): MutualForce {
  checkMutualOptions('mutualCoulomb', options, ['k']);
  const k = checkNumber(options.k ?? COULOMB_CONSTANT, 'mutualCoulomb.k', { min: -1e30, max: 1e30 });
  const square = options.law !== 'inverse-distance';
  return createMutualForce({
    name: 'mutual Coulomb',
    equation: square ? 'F = -k q₁ q₂ r/(r² + ε²)^(3/2)' : 'F = -k q₁ q₂ r/(r² + ε²)',
    parameters: {
      k: { unit: square ? 'N m²/C²' : 'N m/C²', value: k },
      softening: { unit: 'm', value: options.softening ?? 0 },
    },
    strength: 'Charge',
    coefficient: -k,
    signed: true,
    options,
  });
}
