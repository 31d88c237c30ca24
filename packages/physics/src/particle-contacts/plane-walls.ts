// Walls that are half-spaces (2D and 3D), each an entity with PlaneWall. The formulas are in
// kernels/particle-contacts/walls/impact.ts.

import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import { forEachRange } from '../ecs/ranges.ts';
import { PLANE_COLUMNS_BYTES, PlaneColumnsWord } from '../memory/layouts.gen.ts';
import { allocateRecord } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import type { LocalSystem } from '../world/types.ts';
import { beginImpacts } from './impact-list.ts';
import { collisionKernels } from './kernels.ts';
import { retakeRebounds } from './retake-rebounds.ts';

interface PlaneList extends EntityList {
  /** Address of the kernel record of the planes' column addresses. */
  readonly columns: number;
}

const planeList = namedResource<PlaneList>('plane list', (world) => {
  const { nx, ny, nz, offset, restitution, friction } = world.addresses.PlaneWall;
  const { at, words } = allocateRecord(world.internal.arena, PLANE_COLUMNS_BYTES, 'plane walls');
  words.set([nx, ny, nz, offset, restitution, friction], PlaneColumnsWord.nx);
  const start = world.scratch.at.startVelocity;
  words.set([start.x, start.y, start.z], PlaneColumnsWord.startX);
  return { columns: at, ...emptyEntityList() };
});

/**
 * System of the `walls` phase: collides bodies with Mass and Collider against every PlaneWall. The restitution of a
 * contact is the larger of the body's and the wall's, its friction coefficient their geometric mean.
 */
export const planeWalls: LocalSystem = {
  name: 'plane walls',
  handles: 'PlaneWall',
  run: forEachRange((world, first, last, dt) => {
    if (world.internal.counts.PlaneWall === 0 || world.integrator.solvesWalls === true) return;
    const list = planeList(world);
    refreshEntityList(world, list, 'PlaneWall', 0);
    const lag = (world.integrator.velocityLag ?? 0) * dt;
    beginImpacts(world);
    collisionKernels(world).planeWalls(list.columns, list.ids, list.count, dt, lag, first, last);
    retakeRebounds(world, dt);
  }),
};
