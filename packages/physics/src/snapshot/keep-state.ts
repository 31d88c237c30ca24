import { assertUsable } from '../ecs/guards.ts';
import { checkObject } from '../errors/validate.ts';
import { resource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** What is kept, in the order it was named. */
export const keptOf = resource((): object[] => []);

const named = new WeakSet<object>();

/** Whether an object was named to `keepState`, so that it is copied although it may be of a class. */
export function isKept(value: object): boolean {
  return named.has(value);
}

/**
 * Makes objects a part of the world's state: snapshots put their contents aside, and `restore` brings them back, in the
 * same objects. Contents are fields, elements, and all that is in the plain objects, arrays, maps, sets and typed arrays
 * among them; of an object of a class they are its public fields. For whatever your own systems keep: scores, timers,
 * `random.state`.
 * @throws PhysicsError E_TYPE, E_DESTROYED: nothing is kept
 */
export function keepState(world: PhysicsWorld, ...objects: readonly object[]): void {
  assertUsable(world);
  for (const object of objects) checkObject(object, 'keepState: objects');
  for (const object of objects) named.add(object);
  keptOf(world).push(...objects);
}
