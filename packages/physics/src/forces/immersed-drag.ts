// Drag on the part of a body that is in a fluid with a surface.
//
//   F = -f (k |w| + c) w
//
//   f  share of the volume under the surface (see `upthrust`)    w  velocity through the fluid, m/s
//   k  QuadraticDrag, kg/m    c  LinearDrag, kg/s
//
// The coefficients are those of the wholly immersed body in this fluid; list no other drag with them, or it acts in the
// air as well. A share of the volume stands for the share of the frontal area, which differ by a third at most.
// Batchelor, An Introduction to Fluid Dynamics, section 5.11. Cost: a square root and a division a body.
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { hullTable, type Pool, poolState } from './pool';

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function immersedDrag(pool: Pool): Force {
  const { at, parameters } = poolState(pool, 'immersedDrag');
  return {
    name: 'immersed drag',
    equation: 'F = -f (k |w| + c) w',
    parameters,
    reads: ['Position', 'Velocity', 'Hull', 'Collider', 'QuadraticDrag', 'LinearDrag'],
    local: true,
    timeless: true,
    accumulate(world, first, last) {
      const { x, y, z } = world.scratch.at.force;
      lawKernels(world).immersedDrag(at(world), hullTable(world), x, y, z, first, last);
    },
  };
}
