import { addComponent, addEntity, removeEntity, set } from 'bitecs';
import { COMPONENT_NAMES, COMPONENTS, type ComponentName } from '../components/all';
import { PhysicsError } from '../faults/physics-error';
import { checkKeys } from '../faults/validate';
import { checkValues, type FieldValues } from '../store/attach';
import { assertUsable } from '../store/guards';
import { assertBody } from '../store/references';
import type { PhysicsWorld } from '../world';

type FieldsOf<Name extends ComponentName> = {
  readonly [F in keyof (typeof COMPONENTS)[Name]['fields']]?: number;
};

type Key<Name extends ComponentName> = (typeof COMPONENTS)[Name]['key'];
type NamesWithScalar = {
  [Name in ComponentName]: (typeof COMPONENTS)[Name] extends { readonly scalar?: infer S }
    ? S extends string
      ? Name
      : never
    : never;
}[ComponentName];

/** The components of a new body: `{ position: { x: 1 }, velocity: { y: 2 }, mass: 3, collider: { radius: 0.5 } }`. */
export type BodyInput = {
  readonly [Name in ComponentName as Key<Name>]?: FieldsOf<Name> | (Name extends NamesWithScalar ? number : never);
};

const NAME_OF_KEY = new Map<string, ComponentName>(COMPONENT_NAMES.map((name) => [COMPONENTS[name].key, name]));

/** The component a key of `spawn` names. @throws PhysicsError E_UNKNOWN */
export function componentOfKey(key: string): ComponentName {
  const name = NAME_OF_KEY.get(key);
  if (name === undefined) checkKeys({ [key]: 0 }, 'spawn', [...NAME_OF_KEY.keys()]);
  return name as ComponentName;
}

/**
 * Makes one entity with the given components. A component given as `{}` gets its initial values; one left out is
 * absent. All values are checked before anything is made. During a step the body appears when the step ends.
 * @returns the entity id
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_CAPACITY, E_DESTROYED
 */
export function spawn(world: PhysicsWorld, body: BodyInput): number {
  assertUsable(world);
  if (typeof body !== 'object' || body === null) checkKeys(body, 'spawn', []);
  const checked: [ComponentName, FieldValues][] = [];
  for (const [key, data] of Object.entries(body)) {
    if (data === undefined) continue;
    const name = componentOfKey(key);
    const values = checkValues(name, data);
    const spec = COMPONENTS[name];
    if ('complete' in spec && spec.complete !== undefined) {
      spec.complete(
        { ...Object.fromEntries(Object.entries(spec.fields).map(([f, s]) => [f, s.initial])), ...values },
        undefined,
      );
    }
    checked.push([name, values]);
  }
  const eid = newEntity(world);
  for (const [name, values] of checked) addComponent(world, eid, set(world.components[name], values));
  return eid;
}

/** An entity within capacity, or the world as it was. @throws PhysicsError E_CAPACITY */
function newEntity(world: PhysicsWorld): number {
  const eid = addEntity(world);
  if (eid <= world.capacity) return eid;
  removeEntity(world, eid);
  throw capacityError(world, 1);
}

export function capacityError(world: PhysicsWorld, more: number): PhysicsError {
  return new PhysicsError('E_CAPACITY', `no room for ${more} more: the world holds ${world.capacity} entities.`, {
    field: 'capacity',
    value: world.capacity,
    hint: 'Make the world with a larger `capacity`.',
  });
}

/**
 * Removes a body and its entity. During a step it goes when the step ends.
 * @throws PhysicsError E_STALE when there is no such body, E_DESTROYED
 */
export function despawn(world: PhysicsWorld, eid: number): void {
  assertUsable(world);
  assertBody(world, eid);
  const { internal } = world;
  if (world.state !== 'stepping') {
    removeEntity(world, eid);
    return;
  }
  if (internal.leaving.has(eid)) {
    throw new PhysicsError('E_STALE', `body ${eid} is already being removed.`, { entity: eid, value: eid });
  }
  internal.leaving.add(eid);
  internal.commands.push(() => {
    internal.leaving.delete(eid);
    removeEntity(world, eid);
  });
}
