// What `spawnMany` is given, checked and completed before anything is made.
import { COMPONENTS, type ComponentName, keyOf } from '../components/all';
import type { ComponentSpec, FieldSpec } from '../components/define';
import { PhysicsError } from '../faults/physics-error';
import { checkKeys, isRecord, mustBe } from '../faults/validate';
import { checkField, completeValues, type FieldValues, fieldName, initialValues, type Space } from '../store/values';
import { type BodyInput, componentOfKey, lacksVelocity } from './spawn';

/** A value for each body: one number for all, or as many as there are bodies. */
export type Many = number | ArrayLike<number>;

/** Like `BodyInput`, with an array wherever bodies differ. */
export type ManyInput = {
  readonly [Key in keyof BodyInput]?:
    | { readonly [F in keyof Exclude<NonNullable<BodyInput[Key]>, number>]?: Many }
    | (Extract<NonNullable<BodyInput[Key]>, number> extends never ? never : Many)
    | undefined;
};

/** A component of the new bodies, with checked values for all its fields. */
export interface Filling {
  readonly name: ComponentName;
  readonly fields: readonly (readonly [string, Many])[];
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function checkMany(space: Space, values: ManyInput, count: number): Filling[] {
  if (!isRecord(values)) throw mustBe('an object', values, 'spawnMany');
  const fillings: Filling[] = [];
  for (const [key, data] of Object.entries(values)) {
    if (data === undefined) continue;
    const name = componentOfKey(key, 'spawnMany');
    fillings.push({ name, fields: checkComponent(space, name, data, count) });
  }
  if (lacksVelocity(fillings.map(({ name }) => name))) {
    fillings.push({ name: 'Velocity', fields: Object.entries(initialValues('Velocity')) });
  }
  return fillings;
}

function checkComponent(space: Space, name: ComponentName, data: unknown, count: number): [string, Many][] {
  const spec: ComponentSpec = COMPONENTS[name];
  const isScalar = typeof data === 'number' || isList(data);
  const given = (isScalar && spec.scalar !== undefined ? { [spec.scalar]: data } : data) as Record<string, unknown>;
  checkKeys(given, keyOf(name), Object.keys(spec.fields), 'field');
  const columns: Record<string, Many> = { ...initialValues(name) };
  for (const [field, many] of Object.entries(given)) {
    columns[field] = checkColumn(space, fieldName(name, field), spec.fields[field], many, count);
  }
  return Object.entries(spec.complete === undefined ? columns : completeColumns(space, name, columns, count));
}

function isList(value: unknown): value is ArrayLike<number> {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
}

function checkColumn(space: Space, name: string, spec: FieldSpec, many: unknown, count: number): Many {
  if (typeof many === 'number') return checkField(space, spec, name, many);
  if (!isList(many)) {
    throw mustBe(`a number or an array of ${count}`, many, name);
  }
  if (many.length !== count) {
    throw new PhysicsError('E_RANGE', `${name} has ${many.length} values for ${count} bodies.`, { field: name });
  }
  return checkEach(space, name, spec, many);
}

/** The same array when it can be stored as it is, which one plain comparison per value finds out. */
function checkEach(space: Space, name: string, spec: FieldSpec, many: ArrayLike<number>): ArrayLike<number> {
  const { min = -Infinity, max = Infinity, above = -Infinity, integer = false } = spec.bounds;
  const flat = spec.spatial === true && space.dimensions === 2;
  let stored = many;
  for (let i = 0; i < many.length; i++) {
    const value = many[i];
    const inside = typeof value === 'number' && value - value === 0 && value >= min && value <= max && value > above;
    if (inside && !integer && !flat) continue;
    const checked = checkField(space, spec, `${name}[${i}]`, value);
    if (checked === value) continue;
    if (stored === many) stored = Float64Array.from(many);
    (stored as Float64Array)[i] = checked;
  }
  return stored;
}

const nothing = (): FieldValues => ({});

/** Components whose fields depend on each other are completed body by body, or once when all are alike. */
function completeColumns(
  space: Space,
  name: ComponentName,
  columns: Record<string, Many>,
  count: number,
): Record<string, Many> {
  const fields = Object.keys(columns);
  const bodyAt = (i: number): FieldValues =>
    Object.fromEntries(fields.map((field) => [field, valueAt(columns[field], i)]));
  if (fields.every((field) => typeof columns[field] === 'number'))
    return completeValues(space, name, bodyAt(0), nothing);
  const completed = Object.fromEntries(fields.map((field) => [field, new Float64Array(count)]));
  for (let i = 0; i < count; i++) {
    const values = completeValues(space, name, bodyAt(i), nothing);
    for (const field of fields) completed[field][i] = values[field];
  }
  return completed;
}

function valueAt(many: Many, i: number): number {
  return typeof many === 'number' ? many : many[i];
}
