import { shapePool } from '../collision/shapes/shape-pool.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** A number that changes when bodies come, go, or change their shape: a sum of counters that only grow, as 31 bits. */
export function contentVersion({ versions }: PhysicsWorld): number {
  return (versions.membership + versions.style + versions.restored) & 0x7fffffff;
}

/** A number that changes when a record of the pool of shapes is written over: what is known of shapes by their index is out of date. */
export function poolVersion(world: PhysicsWorld): number {
  return (world.versions.restored + shapePool(world).clearings) & 0x7fffffff;
}
