// Walls that are half-spaces (2D and 3D), each an entity with PlaneWall. The formulas are in
// kernels/particle-contacts/walls/impact.ts.

import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { forEachRange } from '../ecs/ranges.ts';
import { allocate } from '../memory/arena.ts';
import { resource } from '../memory/resource.ts';
import type { LocalSystem } from '../world/types.ts';
import { collisionKernels } from './kernels.ts';

interface PlaneList extends EntityList {
  /** Address of the kernel record of the planes' column addresses. */
  readonly columns: number;
}

const planeList = resource<PlaneList>((world) => {
  const { nx, ny, nz, offset, restitution, friction } = world.addresses.PlaneWall;
  const columns = allocate(world.internal.arena, 4 * 6, 'plane walls');
  new Uint32Array(world.memory.buffer, columns, 6).set([nx, ny, nz, offset, restitution, friction]);
  return { columns, ...emptyEntityList() };
});

/**
 * System of the `walls` phase: collides bodies with Mass and Collider against every PlaneWall. The restitution of a
 * contact is the larger of the body's and the wall's, its friction coefficient their geometric mean.
 */
export const planeWalls: LocalSystem = {
  name: 'plane walls',
  run: forEachRange((world, first, last, dt) => {
    if (world.internal.counts.PlaneWall === 0) return;
    const list = planeList(world);
    refreshEntityList(world, list, 'PlaneWall', 0);
    const { x, y, z } = world.scratch.at.startVelocity;
    const lag = (world.integrator.velocityLag ?? 0) * dt;
    collisionKernels(world).planeWalls(list.columns, list.ids, list.count, x, y, z, dt, lag, first, last);
  }),
};
