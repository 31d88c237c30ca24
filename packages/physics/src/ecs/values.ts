// Validation of component values, before the world changes.
import { COMPONENT_NAMES, COMPONENTS, type ComponentName, keyOf } from '../components/all.ts';
import type { ComponentSpec, FieldSpec } from '../components/define.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkNumber, isRecord, isStorable, mustBe, unknownName } from '../errors/validate.ts';
import type { Precision } from '../kernels/instantiate.ts';
import type { FieldValues } from '../world/types.ts';
import { checkBodyId, checkNoPart, recordGenerations, type WorldView } from './body-references.ts';

/**
 * Validates the given values one by one; omitted fields stay omitted.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function checkValues(space: WorldView, name: ComponentName, data: unknown, entity?: number): FieldValues {
  const spec: ComponentSpec = COMPONENTS[name];
  const given = normalise(name, data, entity);
  const values: FieldValues = {};
  for (const field of Object.keys(given)) {
    // A lookup in `spec.fields` alone would find "constructor" in the prototype.
    if (!Object.hasOwn(spec.fields, field)) {
      const more =
        name === 'Collider'
          ? ' In spawn also density; mass stands beside collider, and a shape in it: { shape: box(1, 1) }.'
          : '';
      throw unknownName(keyOf(name), 'field', field, Object.keys(spec.fields), entity, more);
    }
    const known = spec.fields[field] as FieldSpec;
    const named = isRecord(data) ? `${keyOf(name)}.${field}` : keyOf(name);
    values[field] = checkField(space, known, named, given[field], entity);
  }
  return values;
}

/**
 * Completes the values of a component (such as a normalised quaternion), with `present()` for omitted fields.
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

/** The values of a component that was added without values. */
export function initialValues(name: ComponentName): Readonly<FieldValues> {
  return INITIAL[name];
}

/** The name of a field in messages: "position.x", or "mass" if a bare number sets it. */
export function fieldName(name: ComponentName, field: string): string {
  const { scalar }: ComponentSpec = COMPONENTS[name];
  return field === scalar ? keyOf(name) : `${keyOf(name)}.${field}`;
}

/**
 * Validates one value and returns it as it will be stored.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function checkField(space: WorldView, spec: FieldSpec, name: string, value: unknown, entity?: number): number {
  if (value === Infinity && spec.infinite !== undefined) return spec.infinite;
  const given = spec.isFlag === true && typeof value === 'boolean' ? Number(value) : value;
  const checked = isStored(space.precision, spec, given) ? given : refuseNumber(spec, name, given, entity);
  // No body has the id 0: where it is allowed it stands for the world.
  if (spec.generationField !== undefined && checked !== 0) checkBodyId(space, name, checked, entity);
  if (spec.refusesParts === true && checked !== 0) checkNoPart(space, name, checked, entity);
  if (checked !== 0 && spec.spatial === true && space.dimensions === 2) {
    throw new PhysicsError('E_RANGE', `${name} must be 0 in a 2D world, got ${checked}.`, {
      entity,
      field: name,
      value,
      hint: `Create the world with \`dimensions: 3\`.${spec.hint === undefined ? '' : ` ${spec.hint}`}`,
    });
  }
  return checked;
}

/** Returns whether a field takes a number, in a column of this precision. */
export function isStored(precision: Precision, { bounds }: FieldSpec, value: unknown): value is number {
  if (!isStorable(value, bounds)) return false;
  // Small numbers are 0 in a column of f32.
  return bounds.above === undefined || precision === 'f64' || Math.fround(value) > bounds.above;
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE for a number that a field does not take */
export function refuseNumber({ bounds, hint }: FieldSpec, name: string, value: unknown, entity?: number): never {
  checkNumber(value, name, bounds, entity, hint);
  throw mustBe(`greater than ${bounds.above} as a number of f32`, value, name, 'E_RANGE', entity, hint ?? bounds.hint);
}

/**
 * Converts stored values to the form in which they are given: a mass stored as 0 was given as Infinity, and 0 would be
 * rejected.
 */
export function toInputForm(name: ComponentName, values: FieldValues): FieldValues {
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
  const names = Object.keys(fields).join(', ');
  const expected = names && `${scalar ? 'a number or ' : ''}{ ${names} }`;
  const hint = names ? undefined : `It has no values: write ${keyOf(name)}: {}.`;
  throw mustBe(expected || '{}', data, keyOf(name), 'E_TYPE', entity, hint);
}

function isPlain(data: object): boolean {
  const prototype = Object.getPrototypeOf(data);
  return prototype === Object.prototype || prototype === null;
}

/** Returns the fields of a class instance such as DOMPoint, whose accessors are on the prototype. */
function withAccessors(data: Readonly<Record<string, unknown>>, fields: readonly string[]): Record<string, unknown> {
  const values: Record<string, unknown> = { ...data };
  for (const field of fields) if (data[field] !== undefined) values[field] = data[field];
  return values;
}
