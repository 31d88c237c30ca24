import { assertUsable } from '../ecs/guards.ts';
import { checkObject } from '../errors/validate.ts';
import { ResourceKey, stateAt } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** The name of the resource with the objects to save. */
export const KEPT = 'kept objects';

const createList = (): object[] => [];
const KEY = new ResourceKey(false, KEPT, createList);

/** The objects to save, in the order in which they were passed. */
export const keptObjects = (world: PhysicsWorld): object[] => stateAt(world, KEY, createList);

/** The objects that were passed to `keepState`, and what each was then: its kind, and the length or the fields of it. */
const forms = new WeakMap<object, string>();

/** Returns whether an object was passed to `keepState`, which saves it even if it is an instance of a class. */
export function isKept(value: object): boolean {
  return forms.has(value);
}

/** The list of the objects, if there is one: unlike `keptObjects` it makes none. */
export function keptList({ internal }: PhysicsWorld): object[] | undefined {
  return internal.resources.get(KEY) as object[] | undefined;
}

/** What the objects of a list were when they were passed, in their order. */
export function keptForms(list: readonly object[] = []): string[] {
  return list.map((each) => forms.get(each) ?? '');
}

/** Of a class it has no name, because minifiers change it. */
function formOf(object: object): string {
  const kind = Object.prototype.toString.call(object).slice(8, -1);
  if (ArrayBuffer.isView(object) || object instanceof ArrayBuffer) return `${kind} of ${object.byteLength} bytes`;
  if (Array.isArray(object) || object instanceof Map || object instanceof Set || object instanceof Date) return kind;
  return `an object with ${Object.keys(object).sort().join(', ') || 'no field'}`;
}

/**
 * Adds objects to the state of the world: snapshots save their contents, and `restore` writes them back to the same
 * objects. Contents are fields in their order, elements, and everything in nested plain objects, arrays, maps, sets, dates,
 * buffers and typed arrays; for an instance of a class that is passed they are its public fields. Data that is frozen as a
 * whole goes back by reference. Inside these, an instance of a class must be passed itself, or keep one of its own fields, or
 * `snapshot` throws E_TYPE and names it; `markImmutable` excepts what is no state, such as a picture. Refused as well are
 * regular expressions with the flag g or y, weak maps, properties of arrays that are no elements, and symbols as names. An
 * instance without public fields is not saved. Use it for the state of your own systems: scores, timers, `random.state`.
 *
 * What is kept stays kept: an older snapshot, which does not know it, leaves its values as they are, and later snapshots
 * contain it. An object that is passed again is kept once. Objects that come and go in play belong in a list that is kept.
 * `decodeSnapshot` finds an object by its number, and compares its kind and fields of the time when it was passed: two
 * objects with the same fields get each other's values if another program passes them in another order.
 * @throws PhysicsError E_TYPE, E_DESTROYED: no object is added
 */
export function keepState(world: PhysicsWorld, ...objects: readonly object[]): void {
  assertUsable(world);
  for (const object of objects) checkObject(object, 'keepState: objects');
  const list = keptObjects(world);
  const known = new Set(list);
  for (const object of objects) {
    if (known.has(object)) continue;
    forms.set(object, formOf(object));
    known.add(object);
    list.push(object);
  }
}
