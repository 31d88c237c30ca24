import { addComponent, entityExists, hasComponent, set } from 'bitecs';
import { type Shape, storeShape } from '../collision/shapes/2d/shape.ts';
import { noBody } from '../ecs/entity-ref.ts';
import { assertUsable } from '../ecs/guards.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { checkShape } from './collider-shape.ts';

/**
 * Gives a body another shape. Mass and inertia stay as they are until `setDensity` computes them anew, and its hull always does: write
 * `Hull.volume`, m³, and `Hull.halfHeight`, m, of what floats. During a step it takes effect when the step ends.
 * @throws PhysicsError E_TYPE, E_RANGE, also for a body without Collider, E_CAPACITY, E_STALE, E_DESTROYED: nothing is changed
 */
export function setShape(world: PhysicsWorld, eid: number, shape: Shape): void {
  assertUsable(world);
  const { extent } = checkShape(world, shape, 'setShape: shape');
  const { Collider } = world.components;
  if (!Number.isInteger(eid) || !entityExists(world, eid)) throw noBody(eid);
  if (!hasComponent(world, eid, Collider)) {
    const hint = `Spawn it with one, or give it one: addComponent(world, ${eid}, set(world.components.Collider, { radius: 0.5 })).`;
    throw new PhysicsError('E_RANGE', `setShape: body ${eid} has no collider.`, {
      entity: eid,
      field: 'collider',
      hint,
    });
  }
  addComponent(world, eid, set(Collider, { shape: storeShape(world, shape), radius: extent }));
}
