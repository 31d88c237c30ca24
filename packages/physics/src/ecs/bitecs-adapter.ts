// What the engine needs of bitECS beyond its public functions. bitECS keeps its tables under a public symbol, and its
// version is pinned; all that reaches into them is here and in bodies/spawn-many.ts, held by tests.
import {
  $internal,
  type ComponentRef,
  hasComponent,
  Prefab,
  type Query,
  removeEntity,
  type WorldContext,
} from 'bitecs';
import { bitOf, COMPONENT_NAMES, type ComponentName } from '../components/all.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** bitECS's tables of a world; undefined once `deleteWorld` was called. */
export function contextOf(world: PhysicsWorld): WorldContext {
  return (world as unknown as { [$internal]: WorldContext })[$internal];
}

/** The component that columns are, and the world they belong to. */
const owners = new WeakMap<object, { readonly world: PhysicsWorld; readonly name: ComponentName }>();

/** The membership bit of a component of `world`; 0 for any other. */
export function bitIn(world: PhysicsWorld, component: ComponentRef): number {
  const owner = owners.get(component);
  return owner?.world === world ? bitOf(owner.name) : 0;
}

/** Guards bitECS's tables of a new world, when our observers are registered and before anybody else's. */
export function guardTables(world: PhysicsWorld): void {
  for (const name of COMPONENT_NAMES) owners.set(world.components[name], { world, name });
  guardComponents(world);
  guardQueries(world);
}

/**
 * A component of another world would be taken silently, and whoever wrote its columns would move bodies over there.
 * `addComponent` looks its component up first: so a call that adds is told from a later one that only sets.
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
    hint: 'Columns belong to one world: use `world.components` of the world the entity is in.',
  });
}

/** Our observers hang on bitECS's query of each component, which `removeQuery` would take from under them. */
function guardQueries(world: PhysicsWorld): void {
  const { queries } = contextOf(world);
  const { unobserved } = world.internal;
  const ours = new Set<Query>();
  for (const name of COMPONENT_NAMES) {
    // The first that bitECS made for a component.
    const [query] = queriesOf(world, name);
    ours.add(query);
    unobserved.add(query);
    const { subscribe } = query.addObservable;
    query.addObservable.subscribe = (observer) => {
      unobserved.delete(query);
      return subscribe(observer);
    };
  }
  const remove = queries.delete.bind(queries);
  queries.delete = (query) => !ours.has(query) && remove(query);
}

/** bitECS's queries that ask for a component. */
export function queriesOf(world: PhysicsWorld, name: ComponentName): Query[] {
  return [...(contextOf(world).componentMap.get(world.components[name])?.queries ?? [])];
}

/** Whether an entity is a bitECS prefab: a pattern for others, which no query finds and which is no body. */
export function isPrefab(world: PhysicsWorld, eid: number): boolean {
  return hasComponent(world, eid, Prefab);
}

/**
 * Removes an entity even if an observer of a user throws: bitECS would stop half way, with some rows closed and the
 * entity still there. Called again, it goes on after the observer that threw.
 * @throws what the first observer threw, when the entity is gone
 */
export function removeWholly(world: PhysicsWorld, eid: number): void {
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

/** Whether this life of the entity ends with the present step. */
export function isLeaving(world: PhysicsWorld, eid: number): boolean {
  const leaving = world.internal.leaving.get(eid);
  return leaving !== undefined && leaving === contextOf(world).entityComponents.get(eid);
}
