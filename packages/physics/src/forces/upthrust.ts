// Upthrust of a fluid on bodies that are wholly or partly in it.
//
//   F = -ρ V f g        f: share of the volume under the surface, from d = depth of the centre / half height, -1 to 1:
//   sphere  f = ½ + ¼ d (3 - d²)        upright box  f = ½ + ½ d
//
//   potential  U = ρ V g R u(d),  sphere u = d/2 + 3d²/8 - d⁴/16 + 3/16,  box u = (1 + d)²/4,  zero out of the fluid
//
//   ρ  density of the fluid, kg/m³    V  volume, m³: Hull.volume    g  gravity, m/s²    R  half height, m
//
// Archimedes, On Floating Bodies, proposition 5. Valid for a level surface and slow motion: no waves, no pressure drag
// (`immersedDrag`), no accelerated fluid (`addedMass`). Without a level the fluid is everywhere and f = 1: a balloon.
// Polygons, which turn: `polygonUpthrust`. Cost: some 20 operations and one division a body.
import type { Force } from './force';
import { lawKernels } from './law-kernels';
import { hullTable, type Pool, poolState } from './pool';

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function upthrust(pool: Pool): Force {
  const { at, parameters } = poolState(pool, 'upthrust');
  return {
    name: 'upthrust',
    equation: 'F = -ρ V f g',
    parameters,
    reads: ['Position', 'Hull', 'Collider'],
    local: true,
    timeless: true,
    accumulate(world, first, last) {
      if (world.internal.counts.Hull === 0) return;
      const { x, y, z } = world.scratch.at.force;
      lawKernels(world).upthrust(at(world), hullTable(world), x, y, z, first, last);
    },
    potential(world) {
      const { upthrustPotential, balloonPotential } = lawKernels(world);
      const potential = pool.level === undefined ? balloonPotential : upthrustPotential;
      return potential(at(world), hullTable(world), world.lastId + 1);
    },
  };
}
