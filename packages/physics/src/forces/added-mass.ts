// Added mass: a body that accelerates takes some of the fluid along, so the same force accelerates it less.
//
//   F' = F m/(m + C ρ V f)        so that  a = F/(m + C ρ V f)
//
//   F  force of all laws listed before this one, N    C  coefficient: ½ for a sphere, 1 for a cylinder across the flow
//   ρ V f  mass of the fluid displaced, kg
//
// List it last. Without it a bubble lighter than water would leave at hundreds of g; with C = ½ at no more than 2 g.
// The fluid's share of kinetic energy, ½ C ρ V f v², is not in `energy(world)`.
// Lamb, Hydrodynamics, section 92; valid for inviscid flow far from walls. Cost: two divisions a body.
import { checkNumber } from '../faults/validate';
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { hullTable, type Pool, poolState } from './pool';

/**
 * @param coefficient C
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function addedMass(pool: Pool, coefficient = 0.5): Force {
  const { at, parameters } = poolState(pool, 'addedMass');
  const c = checkNumber(coefficient, 'addedMass.coefficient', { min: 0, max: 100 });
  return {
    name: 'added mass',
    equation: "F' = F m / (m + C ρ V f)",
    parameters: { ...parameters, coefficient: { unit: '', value: c } },
    reads: ['Position', 'Mass', 'Hull', 'Collider'],
    local: true,
    timeless: true,
    accumulate(world, first, last) {
      if (world.internal.counts.Hull === 0) return;
      const { x, y, z } = world.scratch.at.force;
      lawKernels(world).addedMass(at(world), hullTable(world), c, x, y, z, first, last);
    },
  };
}
