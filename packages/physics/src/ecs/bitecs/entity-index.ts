// bitECS's list of ids: the living entities, then the free ids in the order in which they will be reused.
import { addEntity } from 'bitecs';
import type { PhysicsWorld } from '../../world/types.ts';
import { contextOf } from './context.ts';

/** A copy of the list, in an array that later copies reuse. */
export interface SavedIndex {
  dense: Uint32Array;
  /** Number of ids in that list. */
  length: number;
  alive: number;
  maxId: number;
}

/** Number of living entities. */
export function countEntities(world: PhysicsWorld): number {
  return contextOf(world).entityIndex.aliveCount;
}

/** The highest id that an entity has or had. */
export function highestId(world: PhysicsWorld): number {
  return contextOf(world).entityIndex.maxId;
}

/** The living entities in bitECS's order. */
export function livingEntities(world: PhysicsWorld): number[] {
  const { dense, aliveCount } = contextOf(world).entityIndex;
  return dense.slice(0, aliveCount);
}

/** @param roundUp a capacity with room for growth */
export function saveIndex(world: PhysicsWorld, into: SavedIndex, roundUp: (count: number) => number): void {
  const { dense, aliveCount, maxId } = contextOf(world).entityIndex;
  if (into.dense.length < dense.length) into.dense = new Uint32Array(roundUp(dense.length));
  for (let i = 0; i < dense.length; i++) into.dense[i] = dense[i];
  into.length = dense.length;
  into.alive = aliveCount;
  into.maxId = maxId;
}

/** Returns whether the same entities live, in the same order. */
export function isSameIndex(world: PhysicsWorld, { dense, alive, maxId }: SavedIndex): boolean {
  const index = contextOf(world).entityIndex;
  if (index.aliveCount !== alive || index.maxId !== maxId) return false;
  for (let i = 0; i < alive; i++) if (index.dense[i] !== dense[i]) return false;
  return true;
}

/** Restores the order in which free ids will be reused. */
export function writeIndex(world: PhysicsWorld, { dense, length, alive, maxId }: SavedIndex): void {
  const index = contextOf(world).entityIndex;
  index.dense.length = length;
  for (let i = 0; i < length; i++) {
    index.dense[i] = dense[i];
    index.sparse[dense[i]] = i;
  }
  index.sparse.length = Math.min(index.sparse.length, maxId + 1);
  index.aliveCount = alive;
  index.maxId = maxId;
}

/** Creates an entity with a given id: bitECS returns the first free id. */
export function recreateEntity(world: PhysicsWorld, eid: number): void {
  const index = contextOf(world).entityIndex;
  const { dense, sparse, aliveCount } = index;
  if (dense[sparse[eid]] !== eid) {
    index.maxId = Math.max(index.maxId, eid);
    sparse[eid] = dense.push(eid) - 1;
  }
  swapIds(index, sparse[eid], aliveCount);
  addEntity(world);
}

/**
 * Makes the next `count` calls of `addEntity` return ids up to `maxId`. If the user created entities beyond it, freed ids
 * may be larger: they are moved to the bottom of the stack, where they do not block the others.
 * @returns whether `count` such ids are free
 */
export function reserveIds(world: PhysicsWorld, count: number, maxId: number): boolean {
  const index = contextOf(world).entityIndex;
  if (index.maxId <= maxId) return index.aliveCount + count <= maxId;
  let moved = 0;
  for (let i = index.aliveCount; i < index.dense.length && moved < count; i++) {
    if (index.dense[i] <= maxId) swapIds(index, index.aliveCount + moved++, i);
  }
  return moved === count;
}

function swapIds(
  { dense, sparse }: { readonly dense: number[]; readonly sparse: number[] },
  a: number,
  b: number,
): void {
  [dense[a], dense[b]] = [dense[b], dense[a]];
  sparse[dense[a]] = a;
  sparse[dense[b]] = b;
}
