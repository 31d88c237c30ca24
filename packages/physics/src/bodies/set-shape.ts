import { addComponent, hasComponent, set } from 'bitecs';
import { type Shape, storeShape } from '../collision/shapes/2d/shape.ts';
import { staleError } from '../ecs/entity-ref.ts';
import { assertUsable } from '../ecs/guards.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { checkShape } from './collider-shape.ts';

/**
 * Gives a body another shape. Mass, inertia and hull stay as they are. During a step it takes effect when the step ends.
 * @throws PhysicsError E_TYPE, E_RANGE, E_CAPACITY, E_STALE for an entity without Collider, E_DESTROYED: nothing is
 *   changed
 */
export function setShape(world: PhysicsWorld, eid: number, shape: Shape): void {
  assertUsable(world);
  const { extent } = checkShape(world, shape, 'setShape: shape');
  const { Collider } = world.components;
  if (!Number.isInteger(eid) || !hasComponent(world, eid, Collider)) {
    throw staleError(eid, `there is no body ${String(eid)} with a Collider in this world.`);
  }
  addComponent(world, eid, set(Collider, { shape: storeShape(world, shape), radius: extent }));
}
