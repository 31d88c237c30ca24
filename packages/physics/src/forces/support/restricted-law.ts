// A law restricted to bodies, a region or a time: the same expressions under a condition, so that it is fused into
// the step like the law itself.
import { lawForce } from '../../dynamics/define-law.ts';
import type { LawForce } from '../../dynamics/sum-of-laws.ts';
import { Condition, Scalar, select, Vector, vec3 } from '../../laws/expression.ts';
import { scalar, suppliedScalar, symbolOf, vector } from '../../laws/parameter.ts';
import { structureOf } from '../../laws/structure.ts';
import type { Law, Parameter, ParameterSource } from '../../world/types.ts';
import type { CheckedRestrictions } from './restrictions.ts';

/** The limits as parameters, so that laws with the same kinds of limits share compiled code. */
class LimitParameters {
  readonly parameters: Parameter[] = [];
  readonly names: string[] = [];
  readonly sources: ParameterSource[] = [];

  scalar(name: string, value: number): Scalar {
    return this.#add(name, scalar(''), { when: 'once', write: (_world, into, at) => into.set([value], at) }) as Scalar;
  }

  vector(name: string, { x, y, z }: { x: number; y: number; z: number }): Vector {
    const write: ParameterSource['write'] = (_world, into, at) => into.set([x, y, z], at);
    return this.#add(name, vector(''), { when: 'once', write }) as Vector;
  }

  /** The time at the start of the step, s. */
  startOfStep(): Scalar {
    const start = suppliedScalar(({ time }) => time);
    return this.#add('start of the step', start, {
      when: 'step',
      write: start.supply as ParameterSource['write'],
    }) as Scalar;
  }

  #add(name: string, parameter: Parameter, source: ParameterSource): Scalar | Vector {
    this.names.push(name);
    this.parameters.push(parameter);
    this.sources.push(source);
    return symbolOf(parameter);
  }
}

/** Returns the law inside its limits and zero outside. */
export function restrictedLaw(force: LawForce, limits: CheckedRestrictions): LawForce {
  const { law } = force;
  const name = `${force.name} (restricted)`;
  const added = new LimitParameters();
  const conditions = [
    ...groupConditions(limits),
    ...regionConditions(limits, added),
    ...timeConditions(force, limits, added),
  ];
  if (conditions.length === 0) return { ...force, name };
  const where = conditions.reduce((a, b) => a.and(b));
  const limited = (vector: Vector | undefined) => vector && select(where, vector, vec3(0, 0, 0));
  // Energy changes at the border of a region, and a force may lack a potential for other reasons than its law.
  const isRegion = limits.box !== undefined || limits.ball !== undefined;
  const hasPotential = !isRegion && law.potential !== undefined && force.potential !== undefined;
  const expressions = {
    force: limited(law.force),
    acceleration: limited(law.acceleration),
    torque: limited(law.torque),
    potential: hasPotential ? select(where, law.potential as Scalar, 0) : undefined,
  };
  const parameters = [...law.parameters, ...added.parameters];
  const derived: Law = {
    ...law,
    name,
    parameters,
    ...expressions,
    structure: structureOf(parameters, expressions),
    names: [...law.names, ...added.names],
  };
  const { potential: _, name: __, ...rest } = force;
  return { ...rest, ...lawForce(derived, [...force.sources, ...added.sources], rest) };
}

function groupConditions({ group }: CheckedRestrictions): Condition[] {
  return group.map((component) => new Condition('has', [], component));
}

function regionConditions({ box, ball }: CheckedRestrictions, added: LimitParameters): Condition[] {
  const position = new Vector('position', []);
  if (ball !== undefined) {
    const square = added.scalar('radius²', ball.radius * ball.radius);
    return [position.sub(added.vector('centre', ball.centre)).lengthSquared().lessOrEqual(square)];
  }
  if (box === undefined) return [];
  const [min, max] = [added.vector('min', box.min), added.vector('max', box.max)];
  // In 2D z and both limits are zero, so the comparison holds.
  return (['x', 'y', 'z'] as const).flatMap((axis) => [
    ...(box.min[axis] === -Infinity ? [] : [min[axis].lessOrEqual(position[axis])]),
    ...(box.max[axis] === Infinity ? [] : [position[axis].lessOrEqual(max[axis])]),
  ]);
}

/**
 * A force that consumes resources or applies torque is decided by the start of the step, as a step has one torque; all
 * others by the time of evaluation.
 */
function timeConditions(
  { consumes, law }: LawForce,
  { from, until }: CheckedRestrictions,
  added: LimitParameters,
): Condition[] {
  if (from === -Infinity && until === Infinity) return [];
  const isPerStep = consumes !== undefined || law.torque !== undefined;
  const time = isPerStep ? added.startOfStep() : new Scalar('time', []);
  return [
    ...(from === -Infinity ? [] : [added.scalar('from', from).lessOrEqual(time)]),
    ...(until === Infinity ? [] : [time.less(added.scalar('until', until))]),
  ];
}
