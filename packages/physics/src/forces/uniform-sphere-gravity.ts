// Gravity inside and outside a uniform sphere, such as a planet with a tunnel through it.
//
//   inside   F = -m μ r/R³        U = -m μ (3R² - r²)/(2R³)
//   outside  F = -m μ r/|r|³      U = -m μ/|r|
//
//   m  mass, kg    μ = G M, m³/s² (surface gravity g₀ = μ/R²)    R  radius, m    r  from the centre, m
//
// Newton, Principia I, propositions 73 and 74. Valid for constant density; the field is continuous at the surface.
// Cost: one square root, one division a body.
import { checkKeys, checkNumber } from '../faults/validate';
import { ANY, LENGTHS } from './bounds';
import { CENTRE_KEYS, type CentreOptions, centralForce, LAW, type LawParameters } from './central';
import type { Force } from './force';

export interface UniformSphereOptions extends CentreOptions {
  /** Gravitational parameter μ = G M, m³/s². */
  readonly mu: number;
  /** Radius R of the sphere, m. */
  readonly radius: number;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function uniformSphereGravity(options: UniformSphereOptions): Force {
  checkKeys(options, 'uniformSphereGravity', ['mu', 'radius', ...CENTRE_KEYS]);
  const mu = checkNumber(options.mu, 'uniformSphereGravity.mu', ANY);
  const radius = checkNumber(options.radius, 'uniformSphereGravity.radius', LENGTHS);
  const values: LawParameters = [mu, radius, 0];
  return centralForce(
    {
      name: 'uniform sphere gravity',
      equation: 'F = -m μ r / max(|r|, R)³',
      law: LAW.uniformSphere,
      couplesTo: 'Mass',
      parameters: { mu: { unit: 'm³/s²', value: mu }, radius: { unit: 'm', value: radius } },
      values: () => values,
    },
    options,
    'uniformSphereGravity',
  );
}
