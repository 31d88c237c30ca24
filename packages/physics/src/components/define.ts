import { PhysicsError } from '../errors/physics-error.ts';
import { type Bounds, checkKeys, isRecord, mustBe, unknownName } from '../errors/validate.ts';

/** A column of real numbers: f32 or f64 according to the world's precision. */
export type RealColumn = Float32Array | Float64Array;

/** One field of a component. */
export interface FieldSpec<Kind extends 'real' | 'u32' = 'real' | 'u32'> {
  readonly kind: Kind;
  /** SI unit; empty for a pure number. */
  readonly unit: string;
  /** The default value. */
  readonly initial: number;
  /** The bounds of a value given through the API. Written into a column, only values of components of the package are corrected. */
  readonly bounds: Bounds;
  /** The hint of the error for an invalid value. Default none. */
  readonly hint?: string | undefined;
  /** The number that represents infinity; by default infinity is invalid. */
  readonly infinite?: number | undefined;
  /** Whether the field must be 0 in 2D. Default false. */
  readonly spatial?: boolean | undefined;
  /** Whether it is 0 or 1, given as a boolean too. Default false. */
  readonly isFlag?: boolean | undefined;
  /** For the id of a body: the name of the field with the generation of that body. Default none: it is no reference. */
  readonly generationField?: string | undefined;
  /** Whether a part of a compound body is refused in place of a body. Default false. */
  readonly refusesParts?: boolean | undefined;
}

/** A component: its fields, and the field set by a plain number. `COMPONENTS` names it. */
export interface ComponentSpec<Fields extends Record<string, FieldSpec> = Record<string, FieldSpec>> {
  readonly fields: Fields;
  /** The field that a plain number sets. Default none. */
  readonly scalar?: (keyof Fields & string) | undefined;
  /** Whether its values affect the appearance of a body, not only its pose. Default false. */
  readonly visual?: boolean | undefined;
  /** Validates all values together after each was validated; may normalise them in place. Default none. */
  readonly complete?: ((values: Record<string, number>, entity: number | undefined) => void) | undefined;
}

/** The typed arrays of one component in one world. */
export type ColumnsOf<Spec> = Spec extends { readonly fields: infer Fields }
  ? { readonly [F in keyof Fields]: Fields[F] extends FieldSpec<'u32'> ? Uint32Array : RealColumn }
  : never;

interface FieldOptions {
  readonly initial?: number;
  readonly bounds?: Bounds;
  readonly hint?: string;
  readonly infinite?: number;
  readonly spatial?: boolean;
}

const FIELD_OPTIONS = ['initial', 'bounds', 'hint', 'infinite', 'spatial'];

/** A field of real numbers. @throws PhysicsError E_TYPE, E_UNKNOWN for options */
export function real(unit: string, options: FieldOptions = {}): FieldSpec<'real'> {
  checkKeys(options, 'a field', FIELD_OPTIONS);
  const { initial = 0, bounds = {}, hint, infinite, spatial } = options;
  return { kind: 'real', unit, initial, bounds, hint, infinite, spatial };
}

/** A field of unsigned 32-bit integers: ids, colours, counters. */
export function u32(unit: string, options: FieldOptions = {}): FieldSpec<'u32'> {
  const field = real(unit, options);
  return { ...field, kind: 'u32', bounds: { min: 0, max: 0xffffffff, integer: true, ...field.bounds } };
}

export type FlagSpec = FieldSpec<'u32'> & { readonly isFlag: true };

/** A field that is 0 or 1; `true` and `false` are accepted where values are given. */
export function flag(): FlagSpec {
  return { ...u32('', { bounds: { max: 1 }, hint: 'Give true or false, or 1 or 0.' }), isFlag: true };
}

/** A field with the id of a body. The field `generationField` stores its generation, because ids are reused. */
export function bodyId(generationField: string, refusesParts = false): FieldSpec<'u32'> {
  return { ...u32('id', { bounds: { min: 1 } }), generationField, refusesParts };
}

/** The same, where 0 stands for the world. */
export function bodyIdOrWorld(generationField: string, refusesParts = false): FieldSpec<'u32'> {
  return { ...bodyId(generationField, refusesParts), bounds: u32('id').bounds };
}

/**
 * Normalises fields that form a direction to length 1.
 * @param hint the hint of the error for a zero direction
 * @throws PhysicsError E_RANGE
 */
export function normaliseFields(
  values: Record<string, number>,
  fields: readonly string[],
  what: string,
  hint: string,
  entity: number | undefined,
): void {
  const length = Math.sqrt(fields.reduce((sum, field) => sum + values[field] * values[field], 0));
  if (!(length > 1e-12 && length < Infinity)) {
    const components = fields.map((field) => values[field]).join(', ');
    throw new PhysicsError('E_RANGE', `${what} (${components}) has no direction: its length is ${length}.`, {
      entity,
      field: what,
      value: values,
      hint,
    });
  }
  for (const field of fields) values[field] /= length;
}

/** Whether a value is a component: one of `COMPONENTS`, or one that `defineComponent` made. */
export function isComponent(value: unknown): value is ComponentSpec {
  return isRecord(value) && isRecord(value.fields);
}

/** Declares a component; its columns are made per world. */
export function defineComponent<const Spec extends ComponentSpec<Record<string, FieldSpec>>>(spec: Spec): Spec {
  return spec;
}

/** Refuses the keys that a component does not have, and as `scalar` what is none of its fields. */
type Checked<Spec extends ComponentSpec> = {
  readonly [Key in keyof Spec]: Key extends keyof ComponentSpec ? Spec[Key] : never;
} & { readonly scalar?: (keyof Spec['fields'] & string) | undefined };

/**
 * Declares a component of your own: its fields by `realField` and `wordField`, and as `scalar` the field that a plain number sets. Its columns
 * are made for each world that lists it in `components`; `columnsOf` gives them.
 * @throws PhysicsError E_TYPE; E_UNKNOWN for an option that does not exist and for a `scalar` that is no field
 */
export function defineCheckedComponent<const Spec extends ComponentSpec<Record<string, FieldSpec>>>(
  spec: Spec & Checked<Spec>,
): Spec {
  checkKeys(spec, 'defineComponent', ['fields', 'scalar', 'visual', 'complete']);
  const { fields, scalar }: ComponentSpec = spec;
  if (!isRecord(fields)) throw mustBe('an object with a field for each column', fields, 'defineComponent.fields');
  if (scalar !== undefined && !Object.hasOwn(fields, scalar))
    throw unknownName('the component', 'field', scalar, Object.keys(fields));
  return spec;
}
