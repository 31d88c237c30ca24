import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { reserveIds } from './bitecs/entity-index.ts';

/**
 * Ensures that the next `count` calls of `addEntity` return ids within capacity.
 * @throws PhysicsError E_CAPACITY
 */
export function ensureCapacity(world: PhysicsWorld, count: number): void {
  if (!reserveIds(world, count, world.capacity)) throw capacityError(world, count);
}

export function capacityError(world: PhysicsWorld, more: number, entity?: number): PhysicsError {
  return new PhysicsError(
    'E_CAPACITY',
    `cannot add ${more} more: the capacity of the world is ${world.capacity} entities.`,
    {
      entity,
      field: 'capacity',
      value: world.capacity,
      hint: 'Create the world with a larger `capacity`.',
    },
  );
}
