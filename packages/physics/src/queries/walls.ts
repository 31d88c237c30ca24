// Walls, which queries see beside bodies: entities with SegmentWall or PlaneWall, and those of `boxWalls`.
import type { ComponentName } from '../components/all.ts';
import { type EntityList, emptyEntityList, refreshEntityList } from '../ecs/entity-list.ts';
import type { KernelExports } from '../kernels/rigid-2d.gen.ts';
import { namedResource } from '../memory/resource.ts';
import { listVirtualPlanes, PLANE_SIZE } from '../solver/box-planes.ts';
import type { PhysicsWorld } from '../world/types.ts';

interface WallLists {
  readonly SegmentWall: EntityList;
  readonly PlaneWall: EntityList;
  /** Numbers of the planes of boxes. */
  readonly box: number[];
}

const wallLists = namedResource(
  'wall lists of queries',
  (): WallLists => ({ SegmentWall: emptyEntityList(), PlaneWall: emptyEntityList(), box: [] }),
);

/** What is needed to visit walls: the kernels, and the address of the record of the query. */
export interface WallQuery {
  readonly world: PhysicsWorld;
  readonly kernels: KernelExports;
  readonly at: number;
  /** Entities that are left out. */
  readonly ignored: readonly number[];
  readonly seesWalls: boolean;
}

/**
 * Places one wall after the other for the kernels that test it, and calls `visit` with its entity, or with 0 for a wall of
 * a box that is no entity. Walls out of reach and walls with a number that is not finite are left out.
 * @throws PhysicsError E_CAPACITY
 */
export function visitWalls(query: WallQuery, visit: (id: number) => void): void {
  if (!query.seesWalls) return;
  const { world, kernels, at, ignored } = query;
  const { box } = wallLists(world);
  const count = listVirtualPlanes(world, box);
  for (let i = 0; i < PLANE_SIZE * count; i += PLANE_SIZE) {
    if (kernels.placePlane(at, box[i], box[i + 1], box[i + 2]) === 1) visit(0);
  }
  const { SegmentWall, PlaneWall } = world.components;
  const { ax, ay, bx, by } = SegmentWall;
  for (const id of idsOf(world, 'SegmentWall')) {
    if (!ignored.includes(id) && kernels.placeSegment(at, ax[id], ay[id], bx[id], by[id]) === 1) visit(id);
  }
  const { nx, ny, offset } = PlaneWall;
  for (const id of idsOf(world, 'PlaneWall')) {
    if (!ignored.includes(id) && kernels.placePlane(at, nx[id], ny[id], offset[id]) === 1) visit(id);
  }
}

const NONE = new Uint32Array(0);

function idsOf(world: PhysicsWorld, name: ComponentName & keyof WallLists): Uint32Array {
  if (world.internal.counts[name] === 0) return NONE;
  const list = wallLists(world)[name];
  refreshEntityList(world, list, name, 0);
  return new Uint32Array(world.memory.buffer, list.ids, list.count);
}
