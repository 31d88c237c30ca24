// Values of a component as a caller gives them, checked before the world is touched.
import { COMPONENT_NAMES, COMPONENTS, type ComponentName, keyOf } from '../components/all.ts';
import type { ComponentSpec, FieldSpec } from '../components/define.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkNumber, isRecord, mustBe, unknownName } from '../errors/validate.ts';
import type { FieldValues } from '../world/types.ts';
import { checkBodyId, recordGenerations, type WorldView } from './body-references.ts';

/**
 * The values a caller gave, checked one by one; fields left out stay out.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function checkValues(space: WorldView, name: ComponentName, data: unknown, entity?: number): FieldValues {
  const spec: ComponentSpec = COMPONENTS[name];
  const given = normalise(name, data, entity);
  const values: FieldValues = {};
  for (const field of Object.keys(given)) {
    // Not `spec.fields[field]` alone: "constructor" would be found there, and a function be written to.
    if (!Object.hasOwn(spec.fields, field)) {
      throw unknownName(keyOf(name), 'field', field, Object.keys(spec.fields), entity);
    }
    const known = spec.fields[field] as FieldSpec;
    values[field] = checkField(space, known, fieldName(name, field), given[field], entity);
  }
  return values;
}

/**
 * The values together as the component wants them (a quaternion normalised, say), with `present()` for what was left out.
 * @throws PhysicsError E_RANGE
 */
export function completeValues(
  space: WorldView,
  name: ComponentName,
  values: FieldValues,
  present: () => Readonly<FieldValues>,
  entity?: number,
): FieldValues {
  const spec: ComponentSpec = COMPONENTS[name];
  if (spec.complete === undefined) return values;
  const all = { ...present(), ...values };
  recordGenerations(space, spec, values, all);
  spec.complete(all, entity);
  return all;
}

const INITIAL = Object.fromEntries(
  COMPONENT_NAMES.map((name) => [
    name,
    Object.freeze(Object.fromEntries(Object.entries(COMPONENTS[name].fields).map(([f, { initial }]) => [f, initial]))),
  ]),
) as Record<ComponentName, Readonly<FieldValues>>;

/** What a row holds when its component was added without values. */
export function initialValues(name: ComponentName): Readonly<FieldValues> {
  return INITIAL[name];
}

/** A field as messages name it: "position.x", or "mass" where a bare number sets it. */
export function fieldName(name: ComponentName, field: string): string {
  const { scalar }: ComponentSpec = COMPONENTS[name];
  return field === scalar ? keyOf(name) : `${keyOf(name)}.${field}`;
}

/**
 * One value as it will be stored.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function checkField(space: WorldView, spec: FieldSpec, name: string, value: unknown, entity?: number): number {
  if (value === Infinity && spec.infinite !== undefined) return spec.infinite;
  const checked = checkNumber(value, name, spec.bounds, entity, spec.hint);
  if (spec.life !== undefined) checkBodyId(space, name, checked, entity);
  if (checked !== 0 && spec.spatial === true && space.dimensions === 2) {
    throw new PhysicsError('E_RANGE', `${name} must be 0 in a world of two dimensions, got ${checked}.`, {
      entity,
      field: name,
      value,
      hint: 'Make the world with `dimensions: 3`.',
    });
  }
  return checked;
}

/** Stored values as a caller would give them: a mass stored as 0 was given as Infinity, and 0 would be refused. */
export function asGiven(name: ComponentName, values: FieldValues): FieldValues {
  for (const [field, spec] of Object.entries<FieldSpec>(COMPONENTS[name].fields)) {
    const { above = -Infinity } = spec.bounds;
    if (values[field] === spec.infinite && !(values[field] > above)) values[field] = Infinity;
  }
  return values;
}

function normalise(name: ComponentName, data: unknown, entity: number | undefined): Record<string, unknown> {
  const { scalar, fields }: ComponentSpec = COMPONENTS[name];
  if (isRecord(data)) return isPlain(data) ? data : withAccessors(data, Object.keys(fields));
  if (scalar !== undefined && typeof data === 'number') return { [scalar]: data };
  const wanted = `${scalar ? 'a number or ' : ''}{ ${Object.keys(fields).join(', ')} }`;
  throw mustBe(wanted, data, keyOf(name), 'E_TYPE', entity);
}

function isPlain(data: object): boolean {
  const prototype = Object.getPrototypeOf(data);
  return prototype === Object.prototype || prototype === null;
}

/** The fields of an object of a class, such as DOMPoint, whose accessors are no keys of its own. */
function withAccessors(data: Readonly<Record<string, unknown>>, fields: readonly string[]): Record<string, unknown> {
  const values: Record<string, unknown> = { ...data };
  for (const field of fields) if (data[field] !== undefined) values[field] = data[field];
  return values;
}
