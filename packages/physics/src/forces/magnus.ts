// The Magnus force: a ball that spins is pushed across its path.
//
//   F = C π ρ r³ (ω × w)
//
//   ρ  density of the fluid, kg/m³    r  radius of the collider, m    ω  angular velocity, rad/s
//   w  velocity through the fluid, m/s    C  coefficient, 1 for slow flow
//
// Rubinow and Keller, J. Fluid Mech. 11, 447 (1961), for Re ≪ 1, where C = 1 exactly. Sports balls at Re of 10⁵ have
// C from 0.1 to 1 by spin and roughness: Mehta, Annual Review of Fluid Mechanics 17, 151 (1985). It does no work and,
// here, does not slow the spin: add `angularDrag`. Cost: a cross product a body.
import { checkKeys, checkNumber } from '../faults/validate';
import { NOT_NEGATIVE, POSITIVE } from './bounds';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { type Wind, windState } from './wind';

export interface MagnusOptions {
  /** Density ρ of the fluid, kg/m³. */
  readonly density: number;
  /** C; default 1. */
  readonly coefficient?: number;
  /** How the fluid moves, m/s; default not. */
  readonly wind?: Wind;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function magnus(options: MagnusOptions): Force {
  checkKeys(options, 'magnus', ['density', 'coefficient', 'wind']);
  const density = checkNumber(options.density, 'magnus.density', POSITIVE);
  const coefficient = checkNumber(options.coefficient ?? 1, 'magnus.coefficient', NOT_NEGATIVE);
  const medium = windState(options.wind ?? {}, 'magnus.wind');
  const k = coefficient * Math.PI * density;
  return {
    name: 'Magnus force',
    equation: 'F = C π ρ r³ (ω × w)',
    parameters: { density: { unit: 'kg/m³', value: density }, coefficient: { unit: '', value: coefficient } },
    reads: ['Velocity', 'AngularVelocity', 'Collider'],
    local: true,
    timeless: medium.steady !== undefined,
    accumulate(world, first, last, time) {
      const w = medium.at(world, time);
      const { x, y, z } = world.scratch.at.force;
      const wz = world.dimensions === 3 ? w.z : 0;
      lawKernels(world).magnusForce(x, y, z, k, w.x, w.y, wz, first, last);
    },
  };
}
