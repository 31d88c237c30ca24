// A law's functions are called once, with symbols, and what they return is kept.
import type { ComponentName } from '../components/all.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkFunction, isRecord, mustBe } from '../errors/validate.ts';
import type { Law, Parameter, PhysicsWorld } from '../world/types.ts';
import {
  type BodySymbols,
  bodySymbols,
  componentName,
  type ReadSymbols,
  type Reads,
  refuseUnknown,
} from './body-symbols.ts';
import { checkLaw } from './check-law.ts';
import { Expression, kindOf, type Scalar, type Vector } from './expression.ts';
import { type ParameterSymbols, type Parameters, symbolOf } from './parameter.ts';
import { structureOf } from './structure.ts';
import { Table, type TableParameter } from './table.ts';

/** Operations that may follow each other in a law: what lowers and emits them calls itself as often, in each stage. */
const MAX_DEPTH = 500;

type LawFunction<R, P, Result> = (body: BodySymbols & ReadSymbols<R>, parameters: LawSymbols<P>) => Result;

/** Parameters as symbols, tables among them. */
export type LawSymbols<P> = {
  readonly [Key in keyof P]: P[Key] extends TableParameter<infer Field> ? Table<Field> : ParameterSymbols<P>[Key];
};

/** What a law says of itself. At least one of `force`, `acceleration` and `torque` must be given. */
export interface LawOptions<R extends Reads, P extends Parameters> {
  readonly name: string;
  /** The equation as people write it. */
  readonly formula?: string;
  /** Where the law is from: paper or book, and section. */
  readonly source?: string;
  /** Components whose values it reads, by the name that its functions give them. */
  readonly reads?: R;
  readonly parameters?: P;
  /** For worlds of two, or of three, dimensions alone. */
  readonly dimensions?: 2 | 3;
  /** Force on the body, N. */
  readonly force?: LawFunction<R, P, Vector>;
  /** Acceleration of the body, m/s²: for forces in proportion to mass. */
  readonly acceleration?: LawFunction<R, P, Vector>;
  /** Torque on the body, N m. */
  readonly torque?: LawFunction<R, P, Vector>;
  /** Potential energy of the body, J, whose negative gradient the force is. */
  readonly potential?: LawFunction<R, P, Scalar>;
  /** Called before every step, when edits are still allowed. What it throws comes out of `step`, and nothing has moved. */
  readonly prepare?: (world: PhysicsWorld, dt: number) => void;
  /** Components whose columns `prepare` changes, as an engine burns fuel. */
  readonly consumes?: readonly ComponentName[];
}

/** Records a law. @throws PhysicsError E_TYPE, E_RANGE, E_UNKNOWN, naming the law */
export function recordLaw(
  options: LawOptions<Reads, Parameters>,
  parameters: Readonly<Record<string, Parameter>>,
): Law {
  const { name, dimensions } = options;
  checkParameters(name, parameters);
  const body = bodySymbols(name, options.reads ?? {}) as BodySymbols & ReadSymbols<Reads>;
  const symbols = Object.fromEntries(
    Object.entries(parameters).map(([key, parameter]) => [
      key,
      'fields' in parameter ? new Table(parameter as unknown as TableParameter) : symbolOf(parameter),
    ]),
  );
  const given = refuseUnknown(symbols, `${name}.parameters`) as LawSymbols<Parameters>;
  const ask = <Result extends Expression>(part: 'force' | 'acceleration' | 'torque' | 'potential', shape: string) =>
    record<Result>(name, part, shape, options[part] as undefined | ((...symbols: unknown[]) => unknown), body, given);
  const parts = {
    force: ask<Vector>('force', 'vector'),
    acceleration: ask<Vector>('acceleration', 'vector'),
    torque: ask<Vector>('torque', 'vector'),
    potential: ask<Scalar>('potential', 'scalar'),
  };
  if (parts.force === undefined && parts.acceleration === undefined && parts.torque === undefined) {
    throw new PhysicsError('E_TYPE', `law "${name}" has neither force nor acceleration nor torque.`, { field: name });
  }
  const list = Object.values(parameters);
  const law: Law = {
    name,
    dimensions,
    parameters: list,
    ...parts,
    structure: structureOf(list, parts),
    names: Object.keys(parameters),
    columns: columnNames(options.reads ?? {}),
  };
  checkLaw(law);
  return law;
}

/** Names of columns: that of the component where it has one field, else with the field behind it. */
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
  part: string,
  shape: string,
  make: ((...symbols: unknown[]) => unknown) | undefined,
  ...symbols: readonly unknown[]
): Result | undefined {
  if (make === undefined) return undefined;
  const where = `law "${law}", ${part}`;
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
  throw new PhysicsError(
    'E_RANGE',
    `${where} is a chain of ${result.depth} operations; at most ${MAX_DEPTH} can follow each other.`,
    {
      field: where,
      hint: 'A sum over many things is a table: parameters: { things: table([…], placeOf) }.',
    },
  );
}

/** @throws PhysicsError E_TYPE for what is no parameter */
function checkParameters(law: string, parameters: Readonly<Record<string, unknown>>): void {
  for (const [name, parameter] of Object.entries(parameters)) {
    if (isRecord(parameter) && parameter.kind !== undefined) continue;
    throw mustBe("a parameter, such as scalar('N/m')", parameter, `${law}.parameters.${name}`);
  }
}

/** The same error with the law's name before it. */
function explain(where: string, error: unknown): PhysicsError {
  if (error instanceof PhysicsError) {
    const { code, field, value, hint } = error;
    const problem = error.message.slice(code.length + 2).replace(hint === undefined ? '' : ` ${hint}`, '');
    return new PhysicsError(code, `${where}: ${problem}`, { field: field ?? where, value, hint });
  }
  const isEndless = error instanceof RangeError;
  const problem = isEndless ? 'it calls itself without end.' : `it threw ${error}.`;
  const wrapped = new PhysicsError('E_TYPE', `${where}: ${problem}`, { field: where });
  wrapped.cause = error;
  return wrapped;
}
