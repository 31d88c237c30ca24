// Lists of the entities that have some component, for kernels that visit them one by one.
import { bitOf, type ComponentName } from '../components/all.ts';
import { allocate } from '../memory/arena.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Entities in ascending id. */
export interface Roster {
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
export function emptyRoster(): Roster {
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
export function refreshRoster(
  world: PhysicsWorld,
  roster: Roster,
  name: ComponentName,
  bytes: number,
  bits = bitOf(name),
): boolean {
  const { internal, versions, kernels } = world;
  if (roster.version === versions.membership) return false;
  const most = internal.counts[name];
  if (most > roster.room) {
    const room = Math.min(world.rows, Math.ceil(most / 32) * 64);
    roster.ids = allocate(internal.arena, room * (4 + bytes), `a list of ${name}`);
    roster.at = roster.ids + 4 * room;
    roster.room = room;
  }
  roster.count = most === 0 ? 0 : kernels.listIds(internal.membersAt, bits, world.lastId + 1, roster.ids);
  roster.version = versions.membership;
  return true;
}
