// The entities of emitters that wait to be particles. They have a position, that of their last end or the origin, but no
// particle is there: queries leave them out.
import type { BodyList } from '../ecs/ranges.ts';
import { resource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { emittersOf } from './emit.ts';
import { W } from './record.ts';
import type { Emitter } from './types.ts';

/** A mark for each row, which is zero between calls, and the list that is returned. */
const waitingMemory = resource(
  ({ capacity }) => ({
    marks: new Uint8Array(capacity + 1),
    list: { ids: new Uint32Array(capacity), count: 0 },
  }),
  { excludeFromSnapshot: true },
);

/**
 * Returns the bodies of a list except those that wait in the pool of an emitter. It is the list itself in a world without
 * emitters, and otherwise the same object at every call.
 */
export function withoutWaiting<List extends { readonly ids: ArrayLike<number>; readonly count: number }>(
  world: PhysicsWorld,
  bodies: List,
): List | BodyList {
  const emitters = emittersOf(world).list;
  if (emitters.length === 0) return bodies;
  const { marks, list } = waitingMemory(world);
  for (const emitter of emitters) mark(emitter, marks, 1);
  list.count = 0;
  for (let i = 0; i < bodies.count; i++) {
    if (marks[bodies.ids[i]] === 0) list.ids[list.count++] = bodies.ids[i];
  }
  for (const emitter of emitters) mark(emitter, marks, 0);
  return list;
}

/** Marks the entities that wait: those without a lifetime which the pool still owns. */
function mark({ world, internal }: Emitter, marks: Uint8Array, value: number): void {
  const { buffer } = world.memory;
  const { words } = internal.block.record;
  const capacity = words[W.capacity];
  const ids = new Uint32Array(buffer, words[W.ids], capacity);
  const lifetimes = new Float32Array(buffer, words[W.lifetime], capacity);
  const ownGenerations = new Uint32Array(buffer, words[W.generation], capacity);
  const { generations } = world.internal;
  for (let slot = 0; slot < capacity; slot++) {
    const id = ids[slot];
    if (lifetimes[slot] === 0 && generations[id] === ownGenerations[slot]) marks[id] = value;
  }
}
