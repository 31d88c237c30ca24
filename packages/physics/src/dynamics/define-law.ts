// Laws: forces, accelerations and torques written once as expressions and fused into the step of every world.
import { checkChoice, checkFunction, checkKeys, mustBe } from '../errors/validate.ts';
import type { Reads } from '../laws/body-symbols.ts';
import { type LawOptions, recordLaw } from '../laws/law.ts';
import { type ParameterInput, type Parameters, sourcesOf } from '../laws/parameter.ts';
import { columnsRead } from '../laws/structure.ts';
import type { Force, ForceParameter, Law, Parameter, ParameterSource, PhysicsWorld } from '../world/types.ts';
import { potentialEnergy } from './potential-energy.ts';
import type { LawForce } from './sum-of-laws.ts';

/** Creates the force of a law from the values of its parameters. */
export type LawFactory<P> =
  Record<never, never> extends ParameterInput<P>
    ? (parameters?: ParameterInput<P>) => LawForce
    : (parameters: ParameterInput<P>) => LawForce;

const KEYS = [
  'name',
  'formula',
  'source',
  'reads',
  'parameters',
  'dimensions',
  'force',
  'acceleration',
  'torque',
  'potential',
  'prepare',
  'releaseMemory',
  'consumes',
];

/** The function that creates the force of a law, and a function that records the law on first use. */
interface Definition<P> {
  readonly factory: LawFactory<P>;
  record(): Law;
}

/**
 * Defines a user's law. Its functions are called once, immediately, with symbols, so that errors in them are thrown
 * here. `index.ts` exports it as `defineLaw`.
 * @returns a function that creates the force: `createPhysicsWorld({ forces: [myLaw({ strength: 3 })] })`
 * @throws PhysicsError E_TYPE, E_RANGE, E_UNKNOWN, naming the law
 */
export function defineCheckedLaw<
  const R extends Reads = Record<never, never>,
  const P extends Parameters = Record<never, never>,
>(options: LawOptions<R, P>): LawFactory<P> {
  const { factory, record } = definitionOf<R, P>(options);
  record();
  return factory;
}

/**
 * Defines a law of this package. Its functions are called when its first force is created, so that a page does not
 * spend time on laws it does not use.
 */
export function defineLaw<
  const R extends Reads = Record<never, never>,
  const P extends Parameters = Record<never, never>,
>(options: LawOptions<R, P>): LawFactory<P> {
  return definitionOf<R, P>(options).factory;
}

function definitionOf<R extends Reads, P extends Parameters>(options: LawOptions<R, P>): Definition<P> {
  checkKeys(options, 'defineLaw', KEYS);
  if (typeof options.name !== 'string' || options.name === '') throw mustBe('a text', options.name, 'defineLaw: name');
  if (options.dimensions !== undefined) checkChoice(options.dimensions, `${options.name}.dimensions`, [2, 3]);
  if (options.prepare !== undefined) checkFunction(options.prepare, `${options.name}.prepare`);
  if (options.releaseMemory !== undefined) checkFunction(options.releaseMemory, `${options.name}.releaseMemory`);
  const parameters = (options.parameters ?? {}) as Readonly<Record<string, Parameter>>;
  let recorded: Law | undefined;
  const record = () => {
    recorded ??= recordLaw(options as unknown as LawOptions<Reads, Parameters>, parameters);
    return recorded;
  };
  const factory = (input: unknown = {}) => {
    const sources = sourcesOf(options.name, parameters, input);
    const law = record();
    return lawForce(law, sources, {
      equation: options.formula ?? '',
      parameters: shownParameters(parameters, sources),
      // A consumed column is also read, to know how much is left.
      reads: [...new Set([...columnsRead(law), ...(options.consumes ?? [])])],
      ...(options.prepare && { prepare: options.prepare }),
      ...(options.releaseMemory && { releaseMemory: options.releaseMemory }),
      ...(options.consumes && { consumes: options.consumes }),
    });
  };
  return { factory: factory as LawFactory<P>, record };
}

/** Creates the force of a recorded law with the values of its parameters. */
export function lawForce(
  law: Law,
  sources: readonly ParameterSource[],
  rest: Omit<Force, 'name' | 'local' | 'law' | 'sources' | 'appliesTorque' | 'accumulate' | 'potential'>,
): LawForce {
  const force = { name: law.name, local: true, appliesTorque: law.torque !== undefined, ...rest, law, sources };
  if (law.potential === undefined) return force;
  return { ...force, potential: (world) => potentialEnergy(world, force) };
}

/** Converts parameters to numbers for the documentation; a vector becomes three. */
function shownParameters(
  parameters: Readonly<Record<string, Parameter>>,
  sources: readonly ParameterSource[],
): Readonly<Record<string, ForceParameter>> {
  const shown: Record<string, ForceParameter> = {};
  const values = new Float64Array(3);
  Object.entries(parameters).forEach(([name, { unit, size }], i) => {
    if (sources[i].when !== 'once') return;
    sources[i].write(undefined as unknown as PhysicsWorld, values, 0, 0);
    if (size === 1) shown[name] = { unit, value: values[0] };
    else for (const [a, axis] of ['X', 'Y', 'Z'].entries()) shown[`${name}${axis}`] = { unit, value: values[a] };
  });
  return shown;
}
