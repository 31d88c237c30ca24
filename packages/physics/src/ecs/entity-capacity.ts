import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { contextOf } from './bitecs-adapter.ts';

/**
 * Ensures that the next `count` calls of `addEntity` return ids within capacity.
 *
 * bitECS returns the id freed last. If the user exceeded the capacity with `addEntity`, freed ids may have no row; they
 * are moved to the bottom of the stack, where they do not block the others.
 * @throws PhysicsError E_CAPACITY
 */
export function ensureCapacity(world: PhysicsWorld, count: number): void {
  const { entityIndex } = contextOf(world);
  const { dense, aliveCount, maxId } = entityIndex;
  if (maxId <= world.capacity) {
    if (aliveCount + count > world.capacity) throw capacityError(world, count);
    return;
  }
  let moved = 0;
  for (let i = aliveCount; i < dense.length && moved < count; i++) {
    if (dense[i] > world.capacity) continue;
    const target = aliveCount + moved++;
    [dense[target], dense[i]] = [dense[i], dense[target]];
    entityIndex.sparse[dense[target]] = target;
    entityIndex.sparse[dense[i]] = i;
  }
  if (moved < count) throw capacityError(world, count);
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
