import { assertUsable } from '../ecs/guards.ts';
import { checkFlag, checkFunction, checkKeys, checkObject, checkText } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { allocateTogether } from './arena.ts';

/** The key of a resource. */
export class ResourceKey {
  /**
   * @param excludeFromSnapshot whether snapshots leave the resource out
   * @param name identifies the resource in an encoded snapshot, together with its number among those of the same name
   * @param create the function that creates its state
   */
  constructor(
    readonly excludeFromSnapshot: boolean,
    readonly name: string = '',
    readonly create?: (world: PhysicsWorld) => unknown,
  ) {
    if (name) keysByName.set(name, keysByName.has(name) ? undefined : this);
  }
}

/** The keys that are the only ones of their name. Each of several boxes has a key of the same name, for example. */
const keysByName = new Map<string, ResourceKey | undefined>();

/** Returns the key with this name, undefined if there is none or more than one. */
export function onlyKeyNamed(name: string): ResourceKey | undefined {
  return keysByName.get(name);
}

const immutables = new WeakSet<object>();

/**
 * Declares that this object and its contents no longer change, so that snapshots need not copy it. @throws PhysicsError
 * E_TYPE
 */
export function markImmutable<T extends object>(value: T): T {
  checkObject(value, 'markImmutable: value');
  immutables.add(value);
  return value;
}

/** Returns whether snapshots skip an object. */
export function isImmutable(value: object): boolean {
  return immutables.has(value);
}

/**
 * State of a feature, one per world, created on first use: `const contacts = resource((world) => …)` and then
 * `contacts(world)`. The type of the world names no feature, and a world pays only for the features it uses. Numbers of
 * each body are a typed array of `world.rows` numbers.
 *
 * Snapshots save the contents of plain objects, arrays, maps and typed arrays, and drop resources created after them.
 * @param options.excludeFromSnapshot excludes the resource from snapshots; for data that is not state of the world, such as event
 *   listeners
 * @param options.name needed by `encodeSnapshot`, which finds the resource by it in another world
 */
export function resource<T>(
  create: (world: PhysicsWorld) => T,
  options: { readonly excludeFromSnapshot?: boolean; readonly name?: string } = {},
): (world: PhysicsWorld) => T {
  checkFunction(create, 'resource: create');
  checkKeys(options, 'resource', ['excludeFromSnapshot', 'name']);
  const excludeFromSnapshot = checkFlag(options.excludeFromSnapshot, 'resource.excludeFromSnapshot');
  const key = new ResourceKey(excludeFromSnapshot, checkText(options.name ?? '', 'resource.name'), create);
  return (world) => stateAt(world, key, create);
}

/**
 * The name of resources that another world computes by itself: what follows from options, and lists whose functions know the
 * addresses of a table, which a decoded snapshot moves. `restore` of one drops them, and the next use makes them again.
 */
export const COMPUTED_ANEW = 'computed anew';

/** A resource of this package. */
export function namedResource<T>(name: string, create: (world: PhysicsWorld) => T): (world: PhysicsWorld) => T {
  return resource(create, { name });
}

/** Returns the state at a key, created on first use. If that throws, the memory it allocated is free again. */
export function stateAt<T>(world: PhysicsWorld, key: ResourceKey, create: (world: PhysicsWorld) => T): T {
  assertUsable(world);
  const state = world.internal.resources.get(key) as T | undefined;
  return state === undefined ? createState(world, key, create) : state;
}

/** Apart from `stateAt`, because a function with a closure in it makes an object at every call. */
function createState<T>(world: PhysicsWorld, key: ResourceKey, create: (world: PhysicsWorld) => T): T {
  const { resources, arena } = world.internal;
  const state = allocateTogether(arena, world.kernels.findPage, () => create(world));
  resources.set(key, state);
  return state;
}
