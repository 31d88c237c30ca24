import { checkFunction } from '../faults/validate';
import type { PhysicsWorld } from '../world';
import { assertUsable } from './guards';

/**
 * State of a feature, one per world, made when first asked for: `const contacts = resource((world) => …)` and then
 * `contacts(world)`. So the world's own type names no feature, and a world pays only for those it uses. Memory for
 * kernels comes from `allocate(world.internal.arena, …)`.
 */
export function resource<T>(create: (world: PhysicsWorld) => T): (world: PhysicsWorld) => T {
  checkFunction(create, 'resource: create');
  const key = {};
  return (world) => {
    assertUsable(world);
    const { resources } = world.internal;
    let state = resources.get(key) as T | undefined;
    if (state === undefined) {
      state = create(world);
      resources.set(key, state);
    }
    return state;
  };
}
