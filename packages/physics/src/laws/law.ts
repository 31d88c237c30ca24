// Records laws: their functions are called once with symbols, and the returned expressions are stored.
import type { ComponentName } from '../components/all.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkFunction, isRecord, mustBe } from '../errors/validate.ts';
import type { Law, Parameter, PhysicsWorld } from '../world/types.ts';
import { axial } from './axial.ts';
import {
  type BodySymbols,
  bodySymbols,
  componentName,
  type ReadSymbols,
  type Reads,
  rejectUnknown,
} from './body-symbols.ts';
import { checkLaw } from './check-law.ts';
import { Expression, kindOf, type Scalar, type Vector } from './expression.ts';
import { type ParameterSymbols, type Parameters, symbolOf } from './parameter.ts';
import { structureOf } from './structure.ts';
import { Table, type TableParameter } from './table.ts';

/** Maximum depth of the expressions of a law: lowering and emission recurse to this depth in each stage. */
const MAX_DEPTH = 500;

type LawFunction<R, P, Result> = (body: BodySymbols & ReadSymbols<R>, parameters: LawSymbols<P>) => Result;

/** Parameters as symbols, including tables. */
export type LawSymbols<P> = {
  readonly [Key in keyof P]: P[Key] extends TableParameter<infer Field> ? Table<Field> : ParameterSymbols<P>[Key];
};

/** The description of a law. It must have at least one of `force`, `acceleration` and `torque`. */
export interface LawOptions<R extends Reads, P extends Parameters> {
  readonly name: string;
  /** The equation in mathematical notation. Default none. */
  readonly formula?: string;
  /** Source of the law: paper or book, and section. Default none. */
  readonly source?: string;
  /** Components whose values it reads, by the names that its functions use. Default none. */
  readonly reads?: R;
  /** Its parameters, by name. Default none. */
  readonly parameters?: P;
  /** Restricts the law to 2D or 3D worlds. Default both. */
  readonly dimensions?: 2 | 3;
  /** Force on the body, N. Default none. */
  readonly force?: LawFunction<R, P, Vector>;
  /** Acceleration of the body, m/s²: for forces proportional to mass. Default none. */
  readonly acceleration?: LawFunction<R, P, Vector>;
  /** Torque on the body, N m. Default none. */
  readonly torque?: LawFunction<R, P, Vector>;
  /** Potential energy of the body, J; the force is its negative gradient. Default none. */
  readonly potential?: LawFunction<R, P, Scalar>;
  /**
   * Called before every step, while edits are still allowed. Its exceptions propagate from `step`, before anything
   * moved. Default none.
   */
  readonly prepare?: (world: PhysicsWorld, dt: number) => void;
  /** Called when the force has left a world, to give back memory that it has taken there. Default none. */
  readonly releaseMemory?: (world: PhysicsWorld) => void;
  /** Components whose columns `prepare` changes, as an engine burns fuel. Default none. */
  readonly consumes?: readonly ComponentName[];
}

/** Records a law. @throws PhysicsError E_TYPE, E_RANGE, E_UNKNOWN, naming the law */
export function recordLaw(options: LawOptions<Reads, Parameters>, given: Readonly<Record<string, Parameter>>): Law {
  const { name, dimensions } = options;
  checkParameters(name, given);
  // Values are found by the object: one that stands under two names, or in two laws, must be two.
  const parameters = Object.fromEntries(Object.entries(given).map(([key, parameter]) => [key, { ...parameter }]));
  const body = bodySymbols(name, options.reads ?? {}) as BodySymbols & ReadSymbols<Reads>;
  const symbols = Object.fromEntries(
    Object.entries(parameters).map(([key, parameter]) => [
      key,
      'fields' in parameter ? new Table(parameter as unknown as TableParameter) : symbolOf(parameter),
    ]),
  );
  const known = rejectUnknown(symbols, `${name}.parameters`) as LawSymbols<Parameters>;
  const recordFormula = <Result extends Expression>(
    formula: 'force' | 'acceleration' | 'torque' | 'potential',
    shape: string,
  ) =>
    record<Result>(
      name,
      formula,
      shape,
      options[formula] as undefined | ((...symbols: unknown[]) => unknown),
      body,
      known,
    );
  const formulas = {
    force: recordFormula<Vector>('force', 'vector'),
    acceleration: recordFormula<Vector>('acceleration', 'vector'),
    torque: axial(recordFormula<Vector>('torque', 'vector')),
    potential: recordFormula<Scalar>('potential', 'scalar'),
  };
  if (formulas.force === undefined && formulas.acceleration === undefined && formulas.torque === undefined) {
    throw new PhysicsError('E_TYPE', `law "${name}" has neither force nor acceleration nor torque.`, { field: name });
  }
  const list = Object.values(parameters);
  const law: Law = {
    name,
    dimensions,
    parameters: list,
    ...formulas,
    structure: structureOf(list, formulas),
    names: Object.keys(parameters),
    columns: columnNames(options.reads ?? {}),
  };
  checkLaw(law);
  return law;
}

/** Names of columns: the name of the component if it has one field, otherwise followed by the field. */
function columnNames(reads: Reads): Record<string, string> {
  const names: Record<string, string> = {};
  for (const [key, component] of Object.entries(reads)) {
    const fields = Object.keys(component.fields);
    for (const field of fields) {
      names[`${componentName(component)}.${field}`] = fields.length === 1 ? key : `${key}.${field}`;
    }
  }
  return names;
}

/** Calls a function of a law with symbols. */
function record<Result extends Expression>(
  law: string,
  formula: string,
  shape: string,
  make: ((...symbols: unknown[]) => unknown) | undefined,
  ...symbols: readonly unknown[]
): Result | undefined {
  if (make === undefined) return undefined;
  const where = `law "${law}", ${formula}`;
  checkFunction(make, where);
  let result: unknown;
  try {
    result = make(...symbols);
  } catch (error) {
    throw explain(where, error);
  }
  if (!(result instanceof Expression) || result.shape !== shape) {
    throw new PhysicsError('E_TYPE', `${where} must return a ${shape}, got ${kindOf(result)}.`, {
      field: where,
      value: result,
    });
  }
  if (result.depth <= MAX_DEPTH) return result as Result;
  throw new PhysicsError('E_RANGE', `${where} nests ${result.depth} operations; at most ${MAX_DEPTH} are allowed.`, {
    field: where,
    hint: 'Sum over many terms with a table: parameters: { things: table([…], placeOf) }.',
  });
}

/**
 * @throws PhysicsError E_TYPE if a value is not a parameter
 */
function checkParameters(law: string, parameters: Readonly<Record<string, unknown>>): void {
  for (const [name, parameter] of Object.entries(parameters)) {
    if (isRecord(parameter) && parameter.kind !== undefined) continue;
    throw mustBe("a parameter, such as scalar('N/m')", parameter, `${law}.parameters.${name}`);
  }
}

/** Returns the same error prefixed with the name of the law. */
function explain(where: string, error: unknown): PhysicsError {
  if (error instanceof PhysicsError) {
    const { code, field, value, hint } = error;
    const problem = error.message.slice(code.length + 2).replace(hint === undefined ? '' : ` ${hint}`, '');
    return new PhysicsError(code, `${where}: ${problem}`, { field: field ?? where, value, hint });
  }
  const isEndless = error instanceof RangeError;
  const problem = isEndless ? 'it recurses infinitely.' : `it threw ${error}.`;
  const wrapped = new PhysicsError('E_TYPE', `${where}: ${problem}`, { field: where });
  wrapped.cause = error;
  return wrapped;
}
