import type { ComponentRef, Query } from 'bitecs';
import { COMPONENT_NAMES, type ComponentName, nameOfDefinition } from '../../components/all.ts';
import { isComponent } from '../../components/define.ts';
import { PhysicsError } from '../../errors/physics-error.ts';
import type { PhysicsWorld } from '../../world/types.ts';
import { contextOf } from './context.ts';

/** The world of each component object, and its name, which components of users have none. */
const owners = new WeakMap<object, { readonly world: PhysicsWorld; readonly name?: ComponentName }>();

/** Says that the columns of a component of a user belong to a world. */
export function registerColumns(world: PhysicsWorld, columns: object): void {
  owners.set(columns, { world });
}

/** The name of a component of `world`; undefined for any other. */
export function nameIn(world: PhysicsWorld, component: ComponentRef): ComponentName | undefined {
  const owner = owners.get(component);
  return owner?.world === world ? owner.name : undefined;
}

/** Guards bitECS's tables of a new world, after our observers are registered and before any others. */
export function guardTables(world: PhysicsWorld): void {
  for (const name of COMPONENT_NAMES) owners.set(world.components[name], { world, name });
  guardComponents(world);
  guardQueries(world);
}

/**
 * bitECS would accept a component of another world, and writing its columns would move bodies of that world; and it would accept a
 * definition, which has no columns. `addComponent` looks its component up first, which distinguishes a call that adds from a later call
 * that only sets.
 */
function guardComponents(world: PhysicsWorld): void {
  const { componentMap } = contextOf(world);
  const has = componentMap.has.bind(componentMap);
  componentMap.has = (component) => {
    const owner = owners.get(component);
    if (owner === undefined) {
      if (isComponent(component)) throw definitionError(component);
    } else {
      if (owner.world !== world) throw foreignError(owner.name);
      if (owner.name !== undefined) world.internal.justAdded[owner.name] = 0;
    }
    return has(component);
  };
}

function foreignError(name = 'component'): PhysicsError {
  return new PhysicsError('E_TYPE', `this ${name} belongs to another world.`, {
    field: name,
    hint: 'Columns belong to one world: use `world.components`, or `columnsOf(world, …)`, of the world of the entity.',
  });
}

/** A definition has no rows: values that are set to it would go nowhere. */
function definitionError(component: object): PhysicsError {
  const name = nameOfDefinition(component);
  const columns = name === undefined ? 'columnsOf(world, MyComponent)' : `world.components.${name}`;
  return new PhysicsError(
    'E_TYPE',
    'the definition of a component was given in place of the columns that a world has for it.',
    {
      field: 'components',
      hint: `Give its columns: addComponent(world, id, set(${columns}, { … })), query(world, [${columns}]).`,
    },
  );
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
