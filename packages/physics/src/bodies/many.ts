// Validates and completes the input of `spawnMany` before anything is created.
import type { Shape } from '../collision/shapes/2d/shape.ts';
import { COMPONENTS, type ComponentName, keyOf } from '../components/all.ts';
import type { ComponentSpec, FieldSpec } from '../components/define.ts';
import type { WorldView } from '../ecs/body-references.ts';
import { assertBelongs } from '../ecs/id-lists.ts';
import { checkField, completeValues, fieldName, initialValues, isStored } from '../ecs/values.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkKeys, mustBe } from '../errors/validate.ts';
import type { FieldValues } from '../world/types.ts';
import type { BodyInput } from './body-input.ts';
import { componentOfKey, lacksVelocity } from './spawn.ts';

/** A value for each body: one number for all, or an array with one number per body. */
export type Many = number | ArrayLike<number>;

/** A shape is one for all bodies, or one for each. */
type FieldsOfMany<Fields> = {
  readonly [F in keyof Fields]?: Many | Exclude<Fields[F], number> | (F extends 'shape' ? readonly Shape[] : never);
};

/** Like `BodyInput`, with an array wherever bodies differ. */
export type ManyInput = {
  readonly [Key in keyof BodyInput]?:
    | FieldsOfMany<Exclude<NonNullable<BodyInput[Key]>, number>>
    | (Extract<NonNullable<BodyInput[Key]>, number> extends never ? never : Many)
    | undefined;
};

/** Validated values of a field: one number for all, or one per body. */
export type Column = number | Float64Array;

type Columns = Record<string, Column>;

/** A component of the new bodies, with validated values for all its fields. */
export interface ComponentValues {
  readonly name: ComponentName;
  readonly fields: readonly (readonly [string, Column])[];
}

/** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
export function checkMany(space: WorldView, values: ManyInput, count: number): ComponentValues[] {
  const components: ComponentValues[] = [];
  for (const [key, data] of Object.entries(values)) {
    if (data === undefined) continue;
    const name = componentOfKey(key, 'spawnMany');
    components.push({ name, fields: checkComponent(space, name, data, count) });
  }
  if (lacksVelocity(components.map(({ name }) => name))) {
    components.push({ name: 'Velocity', fields: Object.entries(initialValues('Velocity')) });
  }
  return components;
}

function checkComponent(space: WorldView, name: ComponentName, data: unknown, count: number): [string, Column][] {
  const spec: ComponentSpec = COMPONENTS[name];
  const isScalar = typeof data === 'number' || isList(data);
  const given = (isScalar && spec.scalar !== undefined ? { [spec.scalar]: data } : data) as Record<string, unknown>;
  checkKeys(given, keyOf(name), Object.keys(spec.fields), 'field');
  const columns: Columns = { ...initialValues(name) };
  for (const [field, many] of Object.entries(given)) {
    columns[field] = checkColumn(space, fieldName(name, field), spec.fields[field], many, count);
  }
  return Object.entries(spec.complete === undefined ? columns : completeColumns(space, name, columns, count));
}

/** Whether a value is an array or a typed array. */
export function isList(value: unknown): value is ArrayLike<number> {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
}

function checkColumn(space: WorldView, name: string, spec: FieldSpec, many: unknown, count: number): Column {
  if (typeof many === 'number' || typeof many === 'boolean') return checkField(space, spec, name, many);
  if (!isList(many)) {
    throw mustBe(`a number or an array of ${count}`, many, name);
  }
  if (many.length !== count) {
    throw new PhysicsError('E_RANGE', `${name} has ${many.length} values for ${count} bodies.`, { field: name });
  }
  if (spec.generationField !== undefined) assertBelongs(space, many, name);
  // The full check, which formats names, runs only for values that need it.
  const special = spec.generationField !== undefined || (spec.spatial === true && space.dimensions === 2);
  const checked = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    const value: unknown = many[i];
    const isValid = !special && isStored(space.precision, spec, value);
    checked[i] = isValid ? value : checkField(space, spec, `${name}[${i}]`, value);
  }
  return checked;
}

const noDefaults = (): FieldValues => ({});

/** Components with interdependent fields are completed body by body, or once if all values are equal. */
function completeColumns(space: WorldView, name: ComponentName, columns: Columns, count: number): Columns {
  const given = Object.entries(columns);
  const bodyAt = (i: number): FieldValues => {
    const values = Object.fromEntries(given.map(([field, column]) => [field, valueAt(column, i)]));
    return completeValues(space, name, values, noDefaults);
  };
  if (!given.some(([, column]) => isList(column))) return bodyAt(0);
  const completed = Object.fromEntries(given.map(([field]) => [field, new Float64Array(count)]));
  for (let i = 0; i < count; i++) {
    const values = bodyAt(i);
    for (const field in values) completed[field][i] = values[field];
  }
  return completed;
}

function valueAt(column: Column, i: number): number {
  return typeof column === 'number' ? column : column[i];
}
