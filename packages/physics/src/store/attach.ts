// The bridge from bitECS to the columns: what happens to a row when a component is added, set or removed.
//
// bitECS tells us through observers, so its own idiom works unchanged: addComponent(world, eid, set(Position, { x })).
// While a step runs nothing changes under its feet: the edits are queued and made when it ends.
import { observe, onAdd, onGet, onRemove, onSet, removeComponent } from 'bitecs';
import { bitOf, COMPONENT_NAMES, COMPONENTS, type ComponentName } from '../components/all';
import type { ComponentSpec, FieldSpec } from '../components/define';
import { describe, PhysicsError } from '../faults/physics-error';
import { checkNumber } from '../faults/validate';
import type { PhysicsWorld } from '../world';

/** The checked values of a component, field by field. */
export type FieldValues = Record<string, number>;

/** Registers the observers; called once when the world is made. */
export function observeComponents(world: PhysicsWorld): void {
  for (const name of COMPONENT_NAMES) {
    const component = world.components[name];
    observe(world, onAdd(component), (eid: number) => added(world, eid, name));
    observe(world, onSet(component), (eid: number, data: unknown) => assigned(world, eid, name, data));
    observe(world, onRemove(component), (eid: number) => removed(world, eid, name));
    observe(world, onGet(component), (eid: number) => readRow(world, eid, name));
  }
}

/**
 * Values for a component as a caller gave them, checked, without touching the world.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function checkValues(name: ComponentName, data: unknown, entity?: number): FieldValues {
  const spec: ComponentSpec = COMPONENTS[name];
  const given = normalise(spec, data, entity);
  const values: FieldValues = {};
  for (const field of Object.keys(given)) {
    const known = spec.fields[field];
    if (known === undefined) {
      throw new PhysicsError('E_UNKNOWN', `${spec.key} has no field "${field}".`, {
        entity,
        field,
        hint: `Valid: ${Object.keys(spec.fields).join(', ')}.`,
      });
    }
    values[field] = checkField(spec, field, known, given[field], entity);
  }
  return values;
}

function normalise(spec: ComponentSpec, data: unknown, entity: number | undefined): Record<string, unknown> {
  if (typeof data === 'object' && data !== null && !Array.isArray(data)) return data as Record<string, unknown>;
  if (spec.scalar !== undefined && typeof data === 'number') return { [spec.scalar]: data };
  const fields = Object.keys(spec.fields).join(', ');
  throw new PhysicsError(
    'E_TYPE',
    `${spec.key} must be ${spec.scalar ? 'a number or ' : ''}{ ${fields} }, got ${describe(data)}.`,
    {
      entity,
      field: spec.key,
      value: data,
    },
  );
}

function checkField(
  spec: ComponentSpec,
  field: string,
  known: FieldSpec,
  value: unknown,
  entity: number | undefined,
): number {
  if (value === Infinity && known.infinite !== undefined) return known.infinite;
  const name = field === spec.scalar ? spec.key : `${spec.key}.${field}`;
  return checkNumber(value, name, known.bounds, entity, known.hint);
}

function added(world: PhysicsWorld, eid: number, name: ComponentName): void {
  if (eid > world.capacity) {
    removeComponent(world, eid, world.components[name]);
    throw new PhysicsError('E_CAPACITY', `entity ${eid} is beyond the world's capacity of ${world.capacity}.`, {
      entity: eid,
      field: 'capacity',
      hint: 'Make the world with a larger `capacity`.',
    });
  }
  const { internal } = world;
  internal.justAdded = eid;
  internal.justAddedName = name;
  if (world.state === 'stepping') internal.commands.push(() => openRow(world, eid, name));
  else openRow(world, eid, name);
}

function openRow(world: PhysicsWorld, eid: number, name: ComponentName): void {
  const { internal, versions } = world;
  const bit = bitOf(name);
  if (((internal.members[eid] as number) & bit) !== 0) return;
  internal.members[eid] = (internal.members[eid] as number) | bit;
  internal.counts[name]++;
  if (eid > world.lastId) world.lastId = eid;
  versions.membership++;
  writeRow(world, eid, name, initialValues(name));
}

/** What a row holds when its component was added without values. */
export function initialValues(name: ComponentName): FieldValues {
  const values: FieldValues = {};
  for (const [field, spec] of Object.entries(COMPONENTS[name].fields)) values[field] = spec.initial;
  return values;
}

function assigned(world: PhysicsWorld, eid: number, name: ComponentName, data: unknown): void {
  const { internal } = world;
  const fresh = internal.justAdded === eid && internal.justAddedName === name;
  internal.justAdded = 0;
  let values: FieldValues;
  try {
    values = checkValues(name, data, eid);
    const spec: ComponentSpec = COMPONENTS[name];
    if (spec.complete !== undefined) {
      values = { ...(fresh ? initialValues(name) : readRow(world, eid, name)), ...values };
      spec.complete(values, eid);
    }
  } catch (error) {
    if (fresh) removeComponent(world, eid, world.components[name]);
    throw error;
  }
  if (world.state === 'stepping') internal.commands.push(() => writeRow(world, eid, name, values));
  else writeRow(world, eid, name, values);
}

function readRow(world: PhysicsWorld, eid: number, name: ComponentName): FieldValues {
  const columns = world.components[name] as Record<string, ArrayLike<number>>;
  const values: FieldValues = {};
  for (const field of Object.keys(columns)) values[field] = (columns[field] as ArrayLike<number>)[eid] as number;
  return values;
}

function writeRow(world: PhysicsWorld, eid: number, name: ComponentName, values: FieldValues): void {
  const columns = world.components[name] as Record<string, { [row: number]: number }>;
  for (const field of Object.keys(values)) {
    (columns[field] as { [row: number]: number })[eid] = values[field] as number;
  }
  if (name in world.previous) teleport(world, eid);
  if (name === 'Collider' || (COMPONENTS[name] as ComponentSpec).visual) world.versions.style++;
  if (name === 'Position' || name === 'Velocity') release(world, eid);
}

/** A body someone put in order is in quarantine no longer. */
function release(world: PhysicsWorld, eid: number): void {
  if (((world.internal.members[eid] as number) & bitOf('Quarantined')) !== 0) {
    removeComponent(world, eid, world.components.Quarantined);
  }
}

/** Makes the previous pose of a body its present one, so that renderers do not draw it crossing the gap. */
export function teleport(world: PhysicsWorld, eid: number): void {
  const { components, previous, versions } = world;
  for (const axis of ['x', 'y', 'z'] as const) {
    previous.Position[axis][eid] = components.Position[axis][eid] as number;
    previous.Orientation[axis][eid] = components.Orientation[axis][eid] as number;
  }
  previous.Orientation.w[eid] = components.Orientation.w[eid] as number;
  previous.Rotation.angle[eid] = components.Rotation.angle[eid] as number;
  versions.pose++;
}

function removed(world: PhysicsWorld, eid: number, name: ComponentName): void {
  if (eid > world.capacity) return;
  if (world.state === 'stepping') world.internal.commands.push(() => closeRow(world, eid, name));
  else closeRow(world, eid, name);
}

/** Zeroes a row: an absent component has zero coefficients, so kernels may sweep it without asking. */
function closeRow(world: PhysicsWorld, eid: number, name: ComponentName): void {
  const { internal, versions } = world;
  const bit = bitOf(name);
  if (((internal.members[eid] as number) & bit) === 0) return;
  internal.members[eid] = ((internal.members[eid] as number) & ~bit) >>> 0;
  internal.counts[name]--;
  const columns = world.components[name] as Record<string, { [row: number]: number }>;
  for (const field of Object.keys(columns)) (columns[field] as { [row: number]: number })[eid] = 0;
  if (name in world.previous) teleport(world, eid);
  if (name === 'Position') internal.generations[eid] = (internal.generations[eid] as number) + 1;
  if (internal.members[eid] === 0 && eid === world.lastId) lowerLastId(world);
  versions.membership++;
  versions.style++;
}

function lowerLastId(world: PhysicsWorld): void {
  const { members } = world.internal;
  while (world.lastId > 0 && members[world.lastId] === 0) world.lastId--;
}
