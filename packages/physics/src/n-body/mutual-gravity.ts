// Gravity between all bodies that have mass.
//
//   F_i = Σ_j G m_i m_j (r_j - r_i) / (r² + ε²)^(3/2)        U = -Σ_pairs G m_i m_j / √(r² + ε²)
//   F_i = Σ_j G m_i m_j (r_j - r_i) / (r² + ε²)              U =  Σ_pairs G m_i m_j ln √(r² + ε²)   (law 1/r)
//
//   G  gravitational constant, N m²/kg² (N m/kg² for the law 1/r)      m  mass, kg
//   ε  softening, m (Plummer 1911)                                     r  distance, m
//
// Valid for point masses, or spheres that do not overlap; below the distance ε a body represents a cloud of many.
// Bodies closer than 10⁻¹² (f32; f64: 10⁻¹⁰⁰) of the system's extent count as coincident, where the force is zero. Test
// particles feel forces and exert none, so their momentum and energy are not balanced by the sources.
//
// Direct summation: every pair once, forces equal and opposite. Tree: Barnes & Hut, Nature 324, 446 (1986), with
// quadrupoles (Hernquist, ApJS 64, 715, 1987), one traversal per group of bodies (Barnes, J. Comput. Phys. 87, 161,
// 1990) and cells accepted by their error (Salmon & Warren, J. Comput. Phys. 111, 136, 1994). It does not conserve
// momentum exactly, because action and reaction are approximated separately. Cost: N²/2 pairs, or about N log N.
import { checkNumber } from '../errors/validate.ts';
import { GRAVITATIONAL_CONSTANT } from '../forces/enclosed-mass-gravity.ts';
import { checkMutualOptions, createMutualForce, type MutualForce, type MutualOptions } from './mutual-force.ts';

/** Options of `mutualGravity`. */
export interface MutualGravityOptions extends MutualOptions {
  /** Default 6.6743e-11 N m²/kg². */
  readonly G?: number;
}

/**
 * Creates gravity between all bodies with Mass.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function mutualGravity(options: MutualGravityOptions = {}): MutualForce {
  checkMutualOptions('mutualGravity', options, ['G']);
  const G = checkNumber(options.G ?? GRAVITATIONAL_CONSTANT, 'mutualGravity.G', { min: -1e30, max: 1e30 });
  const square = options.law !== 'inverse-distance';
  return createMutualForce({
    name: 'mutual gravity',
    equation: square ? 'F = G m₁ m₂ r/(r² + ε²)^(3/2)' : 'F = G m₁ m₂ r/(r² + ε²)',
    parameters: {
      G: { unit: square ? 'N m²/kg²' : 'N m/kg²', value: G },
      softening: { unit: 'm', value: options.softening ?? 0 },
    },
    strength: 'Mass',
    coefficient: G,
    signed: false,
    options,
  });
}
