// Sums over a table of numbers: fixed charges, centres of attraction, waves of a turbulent wind. The table may grow and
// change without recompilation.
import { PhysicsError } from '../errors/physics-error.ts';
import type { Parameter, PhysicsWorld } from '../world/types.ts';
import { rejectUnknown } from './body-symbols.ts';
import { constant, Scalar, type ScalarInput, Vector } from './expression.ts';

/** Location of a table in a world's memory: rows of f64, one per field. */
export interface TableLocation {
  readonly at: number;
  readonly count: number;
}

/** A table as a parameter of a law. */
export interface TableParameter<Field extends string = string> extends Parameter<never> {
  readonly fields: readonly Field[];
  readonly supply: (world: PhysicsWorld, into: Float64Array, at: number) => void;
}

/** Identifies the rows of one sum. */
export class SumScope {
  constructor(readonly table: TableParameter) {}
}

/** A field of a row in a sum. */
export interface RowData {
  readonly scope: SumScope;
  readonly index: number;
}

/** Creates a table of f64, whose location is queried before every step. */
export function table<Field extends string>(
  fields: readonly Field[],
  locate: (world: PhysicsWorld) => TableLocation,
): TableParameter<Field> {
  return {
    kind: 'table',
    unit: '',
    bounds: {},
    size: 3,
    overTime: false,
    byDefault: undefined,
    fields,
    supply(world: PhysicsWorld, into: Float64Array, at: number) {
      const tableAt = locate(world);
      into[at] = tableAt.at;
      into[at + 1] = tableAt.count;
    },
  } as unknown as TableParameter<Field>;
}

/** The symbol of a table. */
export class Table<Field extends string = string> {
  constructor(readonly parameter: TableParameter<Field>) {}

  /** Returns the sum of `term` over all rows. */
  sum(term: (row: { readonly [F in Field]: Scalar }) => Vector): Vector;
  sum(term: (row: { readonly [F in Field]: Scalar }) => ScalarInput): Scalar;
  sum(term: (row: { readonly [F in Field]: Scalar }) => Vector | ScalarInput): Vector | Scalar {
    const scope = new SumScope(this.parameter as unknown as TableParameter);
    const fields = this.parameter.fields.map((name, index) => [name, new Scalar('row', [], { scope, index })]);
    const result = term(rejectUnknown(Object.fromEntries(fields), 'the row') as { readonly [F in Field]: Scalar });
    if (result instanceof Vector) return new Vector('sum', [result], scope);
    if (result instanceof Scalar) return new Scalar('sum', [result], scope);
    if (typeof result === 'number') return new Scalar('sum', [constant(result)], scope);
    throw new PhysicsError('E_TYPE', 'sum takes a function that returns a scalar or a vector.', { value: result });
  }
}
