// Parts of compound bodies, as entities: which body a part belongs to, and their removal with it.
import { removeEntityCompletely } from '../ecs/bitecs/remove-entity.ts';
import { assertBody } from '../ecs/entity-ref.ts';
import { isOpen } from '../ecs/rows.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Whether a part's body is there. */
export function hasLiveBody({ components, internal }: PhysicsWorld, part: number): boolean {
  const { body, bodyGeneration } = components.Attachment;
  const id = body[part];
  // Position is the first component: its bit is 1.
  return (internal.members[id] & 1) !== 0 && internal.generations[id] === bodyGeneration[part];
}

/**
 * Returns the body that an entity is a part of, or the entity itself when it is no part: what queries and contact events
 * name is the part.
 * @throws PhysicsError E_STALE, E_DESTROYED
 */
export function bodyOf(world: PhysicsWorld, id: number): number {
  assertBody(world, id);
  return isOpen(world, id, 'Attachment') ? world.components.Attachment.body[id] : id;
}

/** The parts of a body that is there, in ascending order. @throws PhysicsError E_STALE, E_DESTROYED */
export function partsOf(world: PhysicsWorld, body: number): number[] {
  assertBody(world, body);
  const parts: number[] = [];
  if (world.internal.counts.Attachment === 0) return parts;
  for (let id = 1; id <= world.lastId; id++) {
    if (isOpen(world, id, 'Attachment') && world.components.Attachment.body[id] === body && hasLiveBody(world, id)) {
      parts.push(id);
    }
  }
  return parts;
}

/**
 * Removes all parts whose body is gone.
 * @throws the exception of the first observer of a user, after all are removed
 */
export function removeOrphanedParts(world: PhysicsWorld): void {
  const { internal } = world;
  if (internal.counts.Attachment === 0) return;
  let first: { readonly error: unknown } | undefined;
  for (let id = 1; id <= world.lastId; id++) {
    if (!isOpen(world, id, 'Attachment') || hasLiveBody(world, id)) continue;
    try {
      removeEntityCompletely(world, id);
    } catch (error) {
      first ??= { error };
    }
  }
  if (first !== undefined) throw first.error;
}
