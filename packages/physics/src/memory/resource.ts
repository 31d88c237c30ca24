import { assertUsable } from '../ecs/guards.ts';
import { checkFunction, checkObject } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** What a resource is kept under. */
export class ResourceKey {
  /** @param outlives snapshots leave it alone */
  constructor(readonly outlives: boolean) {}
}

const immutables = new WeakSet<object>();

/** Says that nobody changes this object any more, nor what it holds: snapshots need not copy it. @throws PhysicsError E_TYPE */
export function markImmutable<T extends object>(value: T): T {
  checkObject(value, 'constant: value');
  immutables.add(value);
  return value;
}

/** Whether snapshots leave an object alone. */
export function isImmutable(value: object): boolean {
  return immutables.has(value);
}

/**
 * State of a feature, one per world, made when first asked for: `const contacts = resource((world) => …)` and then
 * `contacts(world)`. So the world's own type names no feature, and a world pays only for those it uses. Memory for
 * kernels comes from `allocate(world.internal.arena, …)`.
 *
 * Snapshots save what is in plain objects, arrays, maps and typed arrays, and drop what was made after them.
 * @param options.outlives for what is no state of the world, such as who listens to it: snapshots leave it alone
 */
export function resource<T>(
  create: (world: PhysicsWorld) => T,
  { outlives = false }: { readonly outlives?: boolean } = {},
): (world: PhysicsWorld) => T {
  checkFunction(create, 'resource: create');
  const key = new ResourceKey(outlives);
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
