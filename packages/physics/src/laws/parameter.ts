// Parameters of laws: numbers and vectors with units, constant or functions of time. Their values are in the world's
// memory, so changing them does not recompile.
import { type Bounds, checkKeys, checkNumber, checkObject, type VectorInput } from '../errors/validate.ts';
import type { Parameter, ParameterSource, PhysicsWorld } from '../world/types.ts';
import { Scalar, Vector } from './expression.ts';
import { timeVector, type VectorOverTime } from './time-vector.ts';

interface ParameterOptions<Input> extends Bounds {
  readonly default?: Input;
}

/** A number with a unit. */
export function scalar(
  unit: string,
  options: ParameterOptions<number> & { readonly default: number },
): Optional<number>;
export function scalar(unit: string, options?: ParameterOptions<number>): Parameter<number>;
export function scalar(unit: string, options: ParameterOptions<number> = {}): Parameter<number> {
  checkObject(options, 'the options of a parameter');
  const { default: byDefault, ...bounds } = options;
  return { kind: 'scalar', unit, bounds, size: 1, overTime: false, byDefault };
}

/** An optional parameter. */
export type Optional<Input> = Parameter<Input> & { readonly byDefault: Input };

/** A vector with a unit; omitted axes are zero, as is z in 2D. */
export function vector(
  unit: string,
  options: ParameterOptions<VectorInput> & { default: VectorInput },
): Optional<VectorInput>;
export function vector(unit: string, options?: ParameterOptions<VectorInput>): Parameter<VectorInput>;
export function vector(unit: string, options: ParameterOptions<VectorInput> = {}): Parameter<VectorInput> {
  return vectorParameter('vector', unit, options, false);
}

/** An axial vector, such as a magnetic field: in 2D only z is used. */
export function axialVector(
  unit: string,
  options: ParameterOptions<VectorInput> & { default: VectorInput },
): Optional<VectorInput>;
export function axialVector(unit: string, options?: ParameterOptions<VectorInput>): Parameter<VectorInput>;
export function axialVector(unit: string, options: ParameterOptions<VectorInput> = {}): Parameter<VectorInput> {
  return vectorParameter('axial', unit, options, false);
}

/** A vector, or a function of the time in seconds that returns one. */
export function vectorOverTime(
  unit: string,
  options: ParameterOptions<VectorOverTime> & { default: VectorOverTime },
): Optional<VectorOverTime>;
export function vectorOverTime(unit: string, options?: ParameterOptions<VectorOverTime>): Parameter<VectorOverTime>;
export function vectorOverTime(
  unit: string,
  options: ParameterOptions<VectorOverTime> = {},
): Parameter<VectorOverTime> {
  return vectorParameter('vector', unit, options, true);
}

/** An axial vector, or a function of the time in seconds that returns one. */
export function axialVectorOverTime(
  unit: string,
  options: ParameterOptions<VectorOverTime> = {},
): Parameter<VectorOverTime> {
  return vectorParameter('axial', unit, options, true);
}

function vectorParameter<Input>(
  kind: 'vector' | 'axial',
  unit: string,
  options: ParameterOptions<Input>,
  overTime: boolean,
): Parameter<Input> {
  checkObject(options, 'the options of a parameter');
  const { default: byDefault, ...bounds } = options;
  return { kind, unit, bounds, size: 3, overTime, byDefault };
}

/** A number that the law itself supplies before every step. */
export function suppliedScalar(write: (world: PhysicsWorld) => number): Supplied {
  const supply: Parameter['supply'] = (world, into, at) => {
    into[at] = write(world);
  };
  return { kind: 'scalar', unit: '', bounds: {}, size: 1, overTime: false, byDefault: undefined, supply };
}

/** A vector, axial or not, that the law itself supplies before every step. */
export function suppliedVector(
  write: (world: PhysicsWorld) => { readonly x: number; readonly y: number; readonly z: number },
  kind: 'vector' | 'axial' = 'vector',
): SuppliedVector {
  const supply: Parameter['supply'] = (world, into, at) => {
    const { x, y, z } = write(world);
    into[at] = x;
    into[at + 1] = y;
    into[at + 2] = z;
  };
  return { kind, unit: '', bounds: {}, size: 3, overTime: false, byDefault: undefined, supply };
}

/** Parameters that are not set by options. */
export type Supplied = Parameter<number> & { readonly kind: 'scalar'; readonly supply: object };
export type SuppliedVector = Parameter<VectorInput> & { readonly supply: object };

export type Parameters = Readonly<Record<string, Parameter>>;

/** The symbols of parameters, as passed to the functions of a law. */
export type ParameterSymbols<P> = {
  readonly [Key in keyof P]: P[Key] extends Parameter<number> ? Scalar : Vector;
};

type Given<P> = { [Key in keyof P]: P[Key] extends { supply: object } ? never : Key }[keyof P];
type Omissible<P> = {
  [Key in keyof P]: P[Key] extends { byDefault: infer D } ? (undefined extends D ? never : Key) : never;
}[keyof P];
type InputOf<P> = P extends Parameter<infer Input> ? Input : never;

/** The arguments of a law: required for parameters without a default, optional for the others. */
export type ParameterInput<P> = { readonly [Key in Exclude<Given<P>, Omissible<P>>]: InputOf<P[Key]> } & {
  readonly [Key in Omissible<P>]?: InputOf<P[Key]>;
};

/** Creates the symbol of a parameter. */
export function symbolOf(parameter: Parameter): Scalar | Vector {
  return parameter.kind === 'scalar' ? new Scalar('parameter', [], parameter) : new Vector('parameter', [], parameter);
}

/**
 * Validates the arguments of a law, and determines how each parameter is written to memory.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
 */
export function sourcesOf(
  law: string,
  parameters: Readonly<Record<string, Parameter>>,
  input: unknown,
): ParameterSource[] {
  const names = Object.keys(parameters);
  checkKeys(
    input,
    law,
    names.filter((name) => parameters[name].supply === undefined),
  );
  return names.map((name) => sourceOf(parameters[name], (input as Record<string, unknown>)[name], law, name));
}

function sourceOf(parameter: Parameter, given: unknown, law: string, name: string): ParameterSource {
  const { supply, kind, bounds, byDefault } = parameter;
  if (supply !== undefined) return { when: 'step', write: supply };
  const value = given ?? byDefault;
  if (kind === 'scalar') {
    const number = checkNumber(value, `${law}.${name}`, bounds);
    const write: ParameterSource['write'] = (_world, into, at) => {
      into[at] = number;
    };
    return { when: 'once', write };
  }
  if (typeof value === 'function' && !parameter.overTime) checkNumber(value, `${law}.${name}`);
  const state = timeVector(value as VectorOverTime, `${law}.${name}`, name, bounds);
  const { steady } = state;
  return {
    when: steady === undefined ? 'stage' : 'once',
    zeros: steady && [steady.x === 0, steady.y === 0, steady.z === 0],
    write(world, into, at, time) {
      const { x, y, z } = state.at(world, time);
      into[at] = x;
      into[at + 1] = y;
      into[at + 2] = z;
    },
  };
}
