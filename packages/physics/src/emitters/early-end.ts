// The early end of single particles: a mark which the next step finds, so that counts and lists of endings have it as any other.

import type { PhysicsWorld } from '../world/types.ts';
import { emittersOf } from './emit.ts';
import { ownsSlot, type PoolLists, poolOf } from './pool.ts';
import type { Emitter } from './types.ts';

/** The lists of an emitter's pool, created on first use. */
export function listsOf({ world, capacity, internal }: Emitter): PoolLists {
  internal.pool ??= poolOf(world.memory, internal.block.record.words, capacity);
  return internal.pool;
}

/** Returns the slot of a living particle, or -1. */
export function slotOfParticle(emitter: Emitter, id: number): number {
  const slot = ownSlot(emitter, id);
  return slot >= 0 && listsOf(emitter).lifetime[slot] > 0 ? slot : -1;
}

/** Lets the particle of a slot be older than any lifetime: the next step ends it before anything moves. */
export function markOver(emitter: Emitter, slot: number): void {
  listsOf(emitter).bornAt[slot] = Number.NEGATIVE_INFINITY;
}

/**
 * What `despawn` does with an entity of a pool: its particle ends, and the entity stays. Returns whether one of the world's
 * emitters owns the entity.
 */
export function endIfPooled(world: PhysicsWorld, id: number): boolean {
  for (const emitter of emittersOf(world).list) {
    const slot = ownSlot(emitter, id);
    if (slot < 0) continue;
    if (listsOf(emitter).lifetime[slot] > 0) markOver(emitter, slot);
    return true;
  }
  return false;
}

/** Returns the slot whose entity this is, as long as the pool owns it, or -1. The ids of a pool ascend. */
function ownSlot(emitter: Emitter, id: number): number {
  if (typeof id !== 'number') return -1;
  const { ids } = emitter;
  let low = 0;
  let high = ids.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ids[middle] < id) low = middle + 1;
    else high = middle;
  }
  return ids[low] === id && ownsSlot(emitter.world, listsOf(emitter), low) ? low : -1;
}
