// The Magnus force on a spinning ball, perpendicular to its path.
//
//   F = C π ρ r³ (ω × w)
//
//   ρ  density of the fluid, kg/m³    r  radius of the collider, m    ω  angular velocity, rad/s
//   w  velocity relative to the fluid, m/s    C  coefficient, 1 for slow flow
//
// Rubinow and Keller, J. Fluid Mech. 11, 447 (1961), for Re ≪ 1, where C = 1 exactly. Sports balls at Re of 10⁵ have
// C from 0.1 to 1, depending on spin and roughness: Mehta, Annual Review of Fluid Mechanics 17, 151 (1985). The force
// does no work and does not slow the spin: add `angularDrag`. Rigid bodies and Euler's schemes, which add it to the velocity at once, make
// what it turns by Ω = C π ρ r³ ω/m faster as e^(Ω² h t/2), with steps or sub-steps of h: a ball of table tennis with 300 rad/s goes
// from 20 m/s to 25 m/s in 10 s of rigid bodies at 60 Hz; velocity Verlet gains 0.1 %. Cost: a cross product per body.
import { Collider } from '../components/collider.ts';
import { defineLaw } from '../dynamics/define-law.ts';
import { scalar } from '../laws/parameter.ts';
import type { Force } from '../world/types.ts';
import { NOT_NEGATIVE, POSITIVE } from './support/bounds.ts';
import { type Wind, windParameter } from './support/wind.ts';

/** Options of `magnus`. */
export interface MagnusOptions {
  /** Density ρ of the fluid, kg/m³. */
  readonly density: number;
  /** C; default 1. */
  readonly coefficient?: number;
  /** Velocity of the fluid, m/s; default at rest. */
  readonly wind?: Wind;
}

const law = /* @__PURE__ */ defineLaw({
  name: 'Magnus force',
  formula: 'F = C π ρ r³ (ω × w)',
  source: 'Rubinow and Keller, J. Fluid Mech. 11, 447 (1961).',
  reads: { collider: Collider },
  parameters: {
    density: scalar('kg/m³', POSITIVE),
    coefficient: scalar('', { default: 1, ...NOT_NEGATIVE }),
    wind: windParameter,
  },
  force({ velocity, angularVelocity, collider: { radius } }, { density, coefficient, wind }) {
    const k = coefficient.mul(Math.PI).mul(density);
    return angularVelocity.cross(velocity.sub(wind)).mul(k.mul(radius).mul(radius).mul(radius));
  },
});

/**
 * The Magnus force on spinning balls, perpendicular to path and axis: F = C π ρ r³ (ω × w), with the radius of the collider, m, the
 * angular velocity ω, rad/s, and the velocity w against the fluid, m/s. It acts on bodies with AngularVelocity and Collider, and does not slow
 * the spin. Sports balls have C from 0.1 to 1.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function magnus(options: MagnusOptions): Force {
  return law(options);
}
