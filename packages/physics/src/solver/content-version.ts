import type { PhysicsWorld } from '../world/types.ts';

/** A number that changes when bodies come, go, or change their shape: a sum of counters that only grow, as 31 bits. */
export function contentVersion({ versions }: PhysicsWorld): number {
  return (versions.membership + versions.style + versions.restored) & 0x7fffffff;
}
