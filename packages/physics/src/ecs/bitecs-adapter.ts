// Access to bitECS internals beyond its public functions. bitECS exposes its tables under a public symbol, and its
// version is pinned. All such access is in this file and in bodies/spawn-many.ts, and is covered by tests.
import {
  $internal,
  type ComponentRef,
  hasComponent,
  Prefab,
  type Query,
  removeEntity,
  type WorldContext,
} from 'bitecs';
import { COMPONENT_NAMES, type ComponentName } from '../components/all.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** bitECS's tables of a world; undefined after `deleteWorld`. */
export function contextOf(world: PhysicsWorld): WorldContext {
  return (world as unknown as { [$internal]: WorldContext })[$internal];
}

/** The component name and the world of each component object. */
const owners = new WeakMap<object, { readonly world: PhysicsWorld; readonly name: ComponentName }>();

/** The name of a component of `world`; undefined for any other. */
export function nameIn(world: PhysicsWorld, component: ComponentRef): ComponentName | undefined {
  const owner = owners.get(component);
  return owner?.world === world ? owner.name : undefined;
}

/** Bits that bitECS sets in a column of masks, one mask an entity, when an entity gains components. */
export interface MaskChange {
  readonly masks: number[];
  readonly bits: number;
}

/** What `addComponent` of all these components writes to bitECS's masks. */
export function maskChanges(world: PhysicsWorld, names: readonly ComponentName[]): MaskChange[] {
  const { componentMap, entityMasks } = contextOf(world);
  const bits = new Map<number, number>();
  for (const name of names) {
    const data = componentMap.get(world.components[name]);
    if (data !== undefined) bits.set(data.generationId, (bits.get(data.generationId) ?? 0) | data.bitflag);
  }
  return [...bits].map(([generation, all]) => ({ masks: entityMasks[generation], bits: all }));
}

/** Guards bitECS's tables of a new world, after our observers are registered and before any others. */
export function guardTables(world: PhysicsWorld): void {
  for (const name of COMPONENT_NAMES) owners.set(world.components[name], { world, name });
  guardComponents(world);
  guardQueries(world);
}

/**
 * bitECS would accept a component of another world, and writing its columns would move bodies of that world.
 * `addComponent` looks its component up first, which distinguishes a call that adds from a later call that only sets.
 */
function guardComponents(world: PhysicsWorld): void {
  const { componentMap } = contextOf(world);
  const has = componentMap.has.bind(componentMap);
  componentMap.has = (component) => {
    const owner = owners.get(component);
    if (owner?.world === world) world.internal.justAdded[owner.name] = 0;
    else if (owner !== undefined) throw foreignError(owner.name);
    return has(component);
  };
}

function foreignError(name: ComponentName): PhysicsError {
  return new PhysicsError('E_TYPE', `this ${name} belongs to another world.`, {
    field: name,
    hint: 'Columns belong to one world: use `world.components` of the world of the entity.',
  });
}

/** Our observers depend on bitECS's query of each component, which `removeQuery` would remove. */
function guardQueries(world: PhysicsWorld): void {
  const { queries } = contextOf(world);
  const { unobserved } = world.internal;
  const registered = new Set<Query>();
  for (const name of COMPONENT_NAMES) {
    // The first query that bitECS made for the component.
    const [query] = queriesOf(world, name);
    registered.add(query);
    unobserved.add(query);
    const { subscribe } = query.addObservable;
    query.addObservable.subscribe = (observer) => {
      unobserved.delete(query);
      return subscribe(observer);
    };
  }
  const remove = queries.delete.bind(queries);
  queries.delete = (query) => !registered.has(query) && remove(query);
}

/** bitECS's queries that include a component. */
export function queriesOf(world: PhysicsWorld, name: ComponentName): Query[] {
  return [...(contextOf(world).componentMap.get(world.components[name])?.queries ?? [])];
}

/**
 * Returns whether an entity is a bitECS prefab: a template for other entities, which no query finds and which is not a
 * body.
 */
export function isPrefab(world: PhysicsWorld, eid: number): boolean {
  return hasComponent(world, eid, Prefab);
}

/**
 * Removes an entity even if a user's observer throws: bitECS would stop with some rows closed and the entity still
 * present. Calling it again continues after the observer that threw.
 * @throws the exception of the first observer, after the entity is removed
 */
export function removeEntityCompletely(world: PhysicsWorld, eid: number): void {
  let first: { readonly error: unknown } | undefined;
  for (let left = contextOf(world).queries.size; left >= 0; left--) {
    try {
      removeEntity(world, eid);
      break;
    } catch (error) {
      first ??= { error };
    }
  }
  if (first !== undefined) throw first.error;
}

/** Returns whether the entity of this generation is removed at the end of the present step. */
export function isLeaving(world: PhysicsWorld, eid: number): boolean {
  const leaving = world.internal.leaving.get(eid);
  return leaving !== undefined && leaving === contextOf(world).entityComponents.get(eid);
}
