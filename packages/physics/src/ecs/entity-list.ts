// Lists of the entities with a given component, for kernels that visit them one by one.
import type { ComponentName } from '../components/all.ts';
import { bitOf } from '../components/membership.ts';
import { allocate } from '../memory/arena.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Entities in ascending id. */
export interface EntityList {
  /** Address of the ids. */
  ids: number;
  count: number;
  /** Address of the additional bytes per entity. */
  at: number;
  /** Capacity in entities. */
  capacity: number;
  /** Membership version for which the list is valid. */
  version: number;
}

/** An empty list, to be kept in a resource. */
export function emptyEntityList(): EntityList {
  return { ids: 0, at: 0, count: 0, capacity: 0, version: -1 };
}

/**
 * Rebuilds the list of entities with component `name` if any component was added or removed. The capacity grows to
 * twice the need, because the arena does not free memory.
 * @param bytes additional bytes per entity
 * @param bits components that an entity must have to be listed
 * @returns whether the list was rebuilt
 * @throws PhysicsError E_CAPACITY
 */
export function refreshEntityList(
  world: PhysicsWorld,
  entityList: EntityList,
  name: ComponentName,
  bytes: number,
  bits = bitOf(name),
): boolean {
  const { internal, versions, kernels } = world;
  if (entityList.version === versions.membership) return false;
  const max = internal.counts[name];
  if (max > entityList.capacity) {
    const capacity = Math.min(world.rows, Math.ceil(max / 32) * 64);
    entityList.ids = allocate(internal.arena, capacity * (4 + bytes), `a list of ${name}`);
    entityList.at = entityList.ids + 4 * capacity;
    entityList.capacity = capacity;
  }
  entityList.count =
    max === 0 ? 0 : kernels.collectEntities(internal.membersAt, bits, world.lastId + 1, entityList.ids);
  entityList.version = versions.membership;
  return true;
}
