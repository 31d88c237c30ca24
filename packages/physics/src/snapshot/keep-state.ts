import { assertUsable } from '../ecs/guards.ts';
import { checkObject } from '../errors/validate.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** The name of the resource with the objects to save. */
export const KEPT = 'kept objects';

/** The objects to save, in the order in which they were passed. */
export const keptObjects = namedResource(KEPT, (): object[] => []);

const named = new WeakSet<object>();

/** Returns whether an object was passed to `keepState`, which saves it even if it is an instance of a class. */
export function isKept(value: object): boolean {
  return named.has(value);
}

/**
 * Adds objects to the state of the world: snapshots save their contents, and `restore` writes them back to the same
 * objects. Contents are fields in their order, elements, and everything in nested plain objects, arrays, maps, sets, dates,
 * buffers and typed arrays; for an instance of a class that is passed they are its public fields. Data that is frozen as a
 * whole goes back by reference. Inside these, an instance of a class must be passed itself, or keep one of its own fields, or
 * `snapshot` throws E_TYPE and names it; `markImmutable` excepts what is no state, such as a picture. Refused as well are
 * regular expressions with the flag g or y, weak maps, properties of arrays that are no elements, and symbols as names. An
 * instance without public fields is not saved. Use it for the state of your own systems: scores, timers, `random.state`.
 * @throws PhysicsError E_TYPE, E_DESTROYED: no object is added
 */
export function keepState(world: PhysicsWorld, ...objects: readonly object[]): void {
  assertUsable(world);
  for (const object of objects) checkObject(object, 'keepState: objects');
  for (const object of objects) named.add(object);
  keptObjects(world).push(...objects);
}
