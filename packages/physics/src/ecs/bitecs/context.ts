// bitECS's own tables of a world, which it exposes under a public symbol; its version is pinned. This folder alone reads
// and writes them (test/rules/bitecs.test.ts), and its tests compare the result with that of bitECS's functions.
import { $internal, type WorldContext } from 'bitecs';
import type { PhysicsWorld } from '../../world/types.ts';

/** bitECS's tables of a world; undefined after `deleteWorld`. */
export function contextOf(world: PhysicsWorld): WorldContext {
  return (world as unknown as { [$internal]: WorldContext })[$internal];
}

/** An object that a world keeps as long as bitECS neither deletes nor resets it. */
export function identityOf(world: PhysicsWorld): object | undefined {
  return contextOf(world)?.componentMap;
}

/** An object that belongs to this generation of an entity: the next one with the same id has another. */
export function generationOf(world: PhysicsWorld, eid: number): object | undefined {
  return contextOf(world).entityComponents.get(eid);
}
