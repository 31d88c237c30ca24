// Gravity inside and outside a uniform sphere, such as a planet with a tunnel through it.
//
//   inside   F = -m μ r/R³        U = -m μ (3R² - r²)/(2R³)
//   outside  F = -m μ r/|r|³      U = -m μ/|r|
//
//   m  mass, kg    μ = G M, m³/s² (surface gravity g₀ = μ/R²)    R  radius, m    r  from the centre, m
//
// Newton, Principia I, propositions 73 and 74. Valid for constant density; the field is continuous at the surface.
// Cost: one square root, one division and 17 more operations per body.
import { constant, select } from '../laws/expression.ts';
import { scalar } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { ANY, LENGTH_BOUNDS } from './support/bounds.ts';
import { type CentralLaw, type CentreOptions, centralForce } from './support/central-force.ts';

/** Options of `uniformSphereGravity`. */
export interface UniformSphereOptions extends CentreOptions {
  /** Gravitational parameter μ = G M, m³/s². */
  readonly mu: number;
  /** Radius R of the sphere, m. */
  readonly radius: number;
}

const parameters = { mu: scalar('m³/s²', ANY), radius: scalar('m', LENGTH_BOUNDS) };

const LAW: CentralLaw<typeof parameters> = {
  name: 'uniform sphere gravity',
  formula: 'F = -m μ r / max(|r|, R)³',
  source: 'Newton, Principia (1687), book I, propositions 73 and 74.',
  parameters,
  // Magnitude and direction are multiplied separately: they stay in the range of f32 where r³ does not.
  field(r, { mu, radius }) {
    const inverse = constant(1).div(r.length().max(radius));
    return r.mul(inverse).mul(mu.mul(inverse).mul(inverse)).negate();
  },
  energy(r, { mu, radius }) {
    const relative = r.length().div(radius);
    const inside = constant(3).sub(relative.square()).div(2).div(radius);
    return select(relative.less(1), inside, constant(1).div(r.length())).mul(mu).negate();
  },
};

/**
 * Gravity inside and outside a uniform sphere, such as a planet with a tunnel: F = -m μ r/max(|r|, R)³, N, on every
 * body with mass.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function uniformSphereGravity(options: UniformSphereOptions): Force {
  return centralForce(LAW, 'Mass', options);
}
