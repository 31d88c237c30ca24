import { PhysicsError } from '../errors/physics-error.ts';
import type { Bounds } from '../errors/validate.ts';

/** A column of real numbers: f32 or f64 by the world's precision. */
export type RealColumn = Float32Array | Float64Array;

/** One field of a component. */
export interface FieldSpec<Kind extends 'real' | 'u32' = 'real' | 'u32'> {
  readonly kind: Kind;
  /** SI unit; empty for a pure number. */
  readonly unit: string;
  /** The value a row gets when the component is added without one. */
  readonly initial: number;
  /** What a value given through the API must keep. */
  readonly bounds: Bounds;
  /** Said when a value is refused. */
  readonly hint?: string | undefined;
  /** Infinity is taken and stored as this number. */
  readonly infinite?: number | undefined;
  /** Only 0 is taken in a world of two dimensions. */
  readonly spatial?: boolean | undefined;
  /** The field that notes which life of the body it names: this one is the id of a body of the world. */
  readonly life?: string | undefined;
}

/** A component: its fields, and the one a bare number sets. `COMPONENTS` names it. */
export interface ComponentSpec<Fields extends Record<string, FieldSpec> = Record<string, FieldSpec>> {
  readonly fields: Fields;
  readonly scalar?: (keyof Fields & string) | undefined;
  /** A row's values changed how a body looks, not only where it is. */
  readonly visual?: boolean | undefined;
  /** A last look at all given values together, after each was found valid; may normalise them in place. */
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

/** A field of real numbers. */
export function real(unit: string, options: FieldOptions = {}): FieldSpec<'real'> {
  const { initial = 0, bounds = {}, hint, infinite, spatial } = options;
  return { kind: 'real', unit, initial, bounds, hint, infinite, spatial };
}

/** A field of unsigned 32-bit integers: ids, colours, counters. */
export function u32(unit: string, options: FieldOptions = {}): FieldSpec<'u32'> {
  const field = real(unit, options);
  return { ...field, kind: 'u32', bounds: { min: 0, max: 0xffffffff, integer: true, ...field.bounds } };
}

/** A field that names a body by its id. The field `life` notes the body's generation: ids are given again, lives not. */
export function bodyId(life: string): FieldSpec<'u32'> {
  return { ...u32('id', { bounds: { min: 1 } }), life };
}

/**
 * Makes fields that are a direction together one of length 1.
 * @param hint said of what has no direction
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
    const given = fields.map((field) => values[field]).join(', ');
    throw new PhysicsError('E_RANGE', `${what} (${given}) has no direction.`, {
      entity,
      field: what,
      value: values,
      hint,
    });
  }
  for (const field of fields) values[field] /= length;
}

/** Declares a component; its columns are made per world. */
export function defineComponent<const Spec extends ComponentSpec<Record<string, FieldSpec>>>(spec: Spec): Spec {
  return spec;
}
