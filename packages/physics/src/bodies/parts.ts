// Parts of compound bodies, as entities: which body a part belongs to, and their removal with it.
import { notePartRemoved } from '#warnings';
import { removeEntityCompletely } from '../ecs/bitecs/remove-entity.ts';
import { assertBody, staleError } from '../ecs/entity-ref.ts';
import { isOpen, MAX_NEW_PARTS } from '../ecs/rows.ts';
import { resource } from '../memory/resource.ts';
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
 * @throws PhysicsError E_STALE, also for a part whose body is gone, E_DESTROYED
 */
export function bodyOf(world: PhysicsWorld, id: number): number {
  assertBody(world, id);
  if (!isOpen(world, id, 'Attachment')) return id;
  const body = world.components.Attachment.body[id];
  // Another body may have its id.
  if (hasLiveBody(world, id)) return body;
  throw staleError(
    id,
    `part ${id} has lost its body ${body}.`,
    'It goes with the next step: despawn(world, body) takes parts along.',
  );
}

/**
 * The parts of each body, and some that no longer are its parts. Entities that became parts are added when someone asks, so that
 * neither they nor bodies that go cost a look at all parts.
 */
const partsByBody = resource(() => ({ lists: new Map<number, number[]>(), size: 0, restored: -1 }), {
  excludeFromSnapshot: true,
});

/** The entities that are attached to a body with this id, in ascending order, whether the body is there or not. */
function attachedTo(world: PhysicsWorld, body: number): number[] {
  const { internal, versions, components } = world;
  const { newParts, counts } = internal;
  const index = partsByBody(world);
  const { lists } = index;
  const isIncomplete = index.restored !== versions.restored || newParts.length === MAX_NEW_PARTS;
  if (isIncomplete || index.size > 2 * counts.Attachment + MAX_NEW_PARTS) {
    lists.clear();
    index.size = newParts.length = 0;
    index.restored = versions.restored;
    for (let id = 1; id <= world.lastId; id++) if (isOpen(world, id, 'Attachment')) newParts.push(id);
  }
  for (const part of newParts) {
    const list = lists.get(components.Attachment.body[part]);
    if (list === undefined) lists.set(components.Attachment.body[part], [part]);
    else list.push(part);
  }
  index.size += newParts.length;
  newParts.length = 0;
  const all = lists.get(body);
  if (all === undefined) return [];
  const isAttached = (part: number) => isOpen(world, part, 'Attachment') && components.Attachment.body[part] === body;
  const parts = [...new Set(all)].filter(isAttached).sort((a, b) => a - b);
  index.size += parts.length - all.length;
  lists.set(body, parts);
  return [...parts];
}

/** The parts of a body that is there, in ascending order. @throws PhysicsError E_STALE, E_DESTROYED */
export function partsOf(world: PhysicsWorld, body: number): number[] {
  assertBody(world, body);
  if (world.internal.counts.Attachment === 0) return [];
  return attachedTo(world, body).filter((part) => hasLiveBody(world, part));
}

/**
 * Removes an entity, and its parts if it is a body.
 * @throws the exception of the first observer of a user, after all are removed
 */
export function removeWithParts(world: PhysicsWorld, eid: number): void {
  const parts = world.internal.counts.Attachment === 0 ? [] : attachedTo(world, eid);
  if (isOpen(world, eid, 'Attachment')) notePartRemoved(world, world.components.Attachment.body[eid]);
  try {
    removeEntityCompletely(world, eid);
  } finally {
    removeOrphanedParts(world, parts);
  }
}

/**
 * Removes those of these parts whose body is gone.
 * @throws the exception of the first observer of a user, after all are removed
 */
export function removeOrphanedParts(world: PhysicsWorld, parts: Iterable<number>): void {
  let first: { readonly error: unknown } | undefined;
  for (const id of parts) {
    if (!isOpen(world, id, 'Attachment') || hasLiveBody(world, id)) continue;
    try {
      removeEntityCompletely(world, id);
    } catch (error) {
      first ??= { error };
    }
  }
  if (first !== undefined) throw first.error;
}
