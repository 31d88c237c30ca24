import { hasComponent, Prefab, removeEntity } from 'bitecs';
import type { PhysicsWorld } from '../../world/types.ts';
import { contextOf, generationOf } from './context.ts';

/**
 * Removes an entity even if a user's observer throws: bitECS would stop with some rows closed and the entity still
 * present. Calling it again continues after the observer that threw.
 * @throws the exception of the first observer, after the entity is removed
 */
export function removeEntityCompletely(world: PhysicsWorld, eid: number): void {
  let first: { readonly error: unknown } | undefined;
  for (let left = contextOf(world).queries.size; left >= 0; left--) {
    try {
      removeEntity(world, eid);
      break;
    } catch (error) {
      first ??= { error };
    }
  }
  if (first !== undefined) throw first.error;
}

/** Returns whether the entity of this generation is removed at the end of the present step. */
export function isLeaving(world: PhysicsWorld, eid: number): boolean {
  const leaving = world.internal.edits.leaving.get(eid);
  return leaving !== undefined && leaving === generationOf(world, eid);
}

/**
 * Returns whether an entity is a bitECS prefab: a template for other entities, which no query finds and which is not a
 * body.
 */
export function isPrefab(world: PhysicsWorld, eid: number): boolean {
  return hasComponent(world, eid, Prefab);
}
