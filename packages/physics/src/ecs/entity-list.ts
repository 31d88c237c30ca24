// Lists of the entities that have some component, for kernels that visit them one by one.
import { bitOf, type ComponentName } from '../components/all.ts';
import { allocate } from '../memory/arena.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Entities in ascending id. */
export interface EntityList {
  /** Address of their ids. */
  ids: number;
  count: number;
  /** Address of what else was asked for each. */
  at: number;
  /** How many there is room for. */
  room: number;
  /** Membership version it belongs to. */
  version: number;
}

/** A list of nobody, to be kept in a resource. */
export function emptyEntityList(): EntityList {
  return { ids: 0, at: 0, count: 0, room: 0, version: -1 };
}

/**
 * Lists the entities with component `name` anew when any component came or went. Room grows to twice what is needed,
 * because the arena gives nothing back.
 * @param bytes wanted for each entity besides
 * @param bits what an entity must have to be listed
 * @returns whether it was listed anew
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
  const most = internal.counts[name];
  if (most > entityList.room) {
    const room = Math.min(world.rows, Math.ceil(most / 32) * 64);
    entityList.ids = allocate(internal.arena, room * (4 + bytes), `a list of ${name}`);
    entityList.at = entityList.ids + 4 * room;
    entityList.room = room;
  }
  entityList.count = most === 0 ? 0 : kernels.listIds(internal.membersAt, bits, world.lastId + 1, entityList.ids);
  entityList.version = versions.membership;
  return true;
}
