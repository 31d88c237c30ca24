import { generationOf } from '../ecs/bitecs/context.ts';
import { noBody } from '../ecs/entity-ref.ts';
import { assertUsable } from '../ecs/guards.ts';
import { assertBelongs } from '../ecs/id-lists.ts';
import { mustBe } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { isList } from './many.ts';
import { mayDespawn, remove } from './spawn.ts';

/**
 * Removes many bodies as `despawn` does one, in the order of the list: all of them, or none if one of the ids names nothing. An id
 * that comes twice is removed once, and so is a part that goes with its body. The list may be the result of a query.
 * @throws PhysicsError E_TYPE, E_STALE if there is no entity with one of the ids, E_DESTROYED; and the first exception of user
 *   observers, after all are removed
 */
export function despawnMany(world: PhysicsWorld, ids: ArrayLike<number>): void {
  assertUsable(world);
  if (!isList(ids)) throw mustBe('an array of ids', ids, 'ids');
  assertBelongs(world, ids, 'ids');
  const lives = new Map<number, unknown>();
  // The result of a query changes when its bodies go, and an observer may use their ids again.
  for (const eid of Array.from(ids)) {
    if (!mayDespawn(world, eid)) throw noBody(eid);
    lives.set(eid, generationOf(world, eid));
  }
  const errors: unknown[] = [];
  for (const [eid, life] of lives) {
    if (!mayDespawn(world, eid) || generationOf(world, eid) !== life) continue;
    try {
      remove(world, eid);
    } catch (error) {
      errors.push(error);
    }
  }
  if (errors.length > 0) throw errors[0];
}
