// Integrators with a fixed number of stages, written as expressions: the state after the step, and the states and times
// at which the forces are evaluated.

import { checkObject } from '../errors/validate.ts';
import type { Parameter, ParameterSource, Scheme } from '../world/types.ts';
import { type Expression, Scalar, scalarOf, Vector, vectorOf } from './expression.ts';
import { structureOf } from './structure.ts';

/** The state of a body, the other values that a scheme may use, and the result. */
export interface SchemeState {
  readonly position: Vector;
  readonly velocity: Vector;
  /** Length of the step, s. */
  readonly dt: Scalar;
  /**
   * Length of the last step, s; 0 if the body did not make the world's last step with this scheme, as one that is new or that
   * had no mass, and for a scheme without memory.
   */
  readonly lastDt: Scalar;
  /** Electric charge of the body, C, and its mass, kg. */
  readonly charge: Scalar;
  readonly mass: Scalar;
  /** Vectors that the scheme keeps for each body between steps: zeros where `lastDt` is 0. */
  readonly memory: readonly Vector[];
}

/** What a scheme returns: the state at the end of the step. */
export interface SchemeResult {
  readonly position: Vector;
  readonly velocity: Vector;
  /** New values of the vectors that the scheme keeps, as many as it declares. Default none. */
  readonly memory?: readonly Vector[];
}

/**
 * The change of velocity F/m h that all forces cause in `duration` (s) if they stay as they are at a position and
 * velocity, `fraction` of a step after its start. Each call whose result is used counts as an evaluation.
 */
export type Kick = (position: Vector, velocity: Vector, fraction: number, duration: Scalar) => Vector;

/** A step as expressions. */
export type SchemeFunction = (state: SchemeState, kick: Kick, parameters: readonly (Scalar | Vector)[]) => SchemeResult;

/** The data of a force evaluation. */
export interface StageData {
  stage: number;
  readonly fraction: number;
}

/** Parameters of a scheme, and vectors that it keeps for each body. */
export interface SchemeOptions {
  /** Number of vectors that the scheme keeps for each body between steps. Default 0. */
  readonly memory?: number;
  readonly parameters?: readonly Parameter[];
  readonly sources?: readonly ParameterSource[];
}

/** Records a step. @throws PhysicsError E_TYPE if a method gets an argument of the wrong type */
export function recordScheme(step: SchemeFunction, options: SchemeOptions = {}): Scheme {
  const { memory = 0, parameters = [], sources = [] } = options;
  const kicks: Vector[] = [];
  const kick: Kick = (position, velocity, fraction, duration) => {
    const data: StageData = { stage: kicks.length, fraction };
    const args = [vectorOf(position, 'kick'), vectorOf(velocity, 'kick'), scalarOf(duration, 'kick')];
    kicks.push(new Vector('kick', args, data));
    return kicks[data.stage];
  };
  const result = step(
    {
      position: new Vector('position', []),
      velocity: new Vector('velocity', []),
      dt: new Scalar('dt', []),
      lastDt: new Scalar('lastDt', []),
      charge: new Scalar('charge', []),
      mass: new Scalar('mass', []),
      memory: Array.from({ length: memory }, (_, i) => new Vector(`memory${i}`, [])),
    },
    kick,
    parameters.map((parameter) =>
      parameter.kind === 'scalar' ? new Scalar('parameter', [], parameter) : new Vector('parameter', [], parameter),
    ),
  );
  checkObject(result, 'defineIntegrator: the result of the function');
  const { position, velocity, memory: memoryVectors = [] } = result;
  const formulas = {
    position,
    velocity,
    ...Object.fromEntries(memoryVectors.map((vector, i) => [`memory${i}`, vector])),
  };
  const stages = numberStages(kicks, Object.values(formulas));
  const structure = `${structureOf(parameters, formulas)};${stages}`;
  return { structure, position, velocity, memory: memoryVectors, stages, parameters, sources };
}

/** Numbers the evaluations that a result needs, and returns the fractions at which they are. Others have no stage. */
function numberStages(kicks: readonly Vector[], results: readonly (Expression | undefined)[]): number[] {
  const seen = new Set<Expression>();
  const visit = (expression: Expression | undefined) => {
    if (expression === undefined || seen.has(expression)) return;
    seen.add(expression);
    expression.args.forEach(visit);
  };
  results.forEach(visit);
  return kicks
    .filter((each) => seen.has(each))
    .map(({ data }, stage) => {
      (data as StageData).stage = stage;
      return (data as StageData).fraction;
    });
}
