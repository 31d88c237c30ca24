import type { ComponentName } from '../components/all.ts';
import type { PhysicsWorld } from '../world/create-world.ts';
import type { Law } from './law.ts';
import type { ParameterSource } from './parameter.ts';

/** A parameter of a force as its documentation shows it. */
export interface ForceParameter {
  readonly unit: string;
  readonly value: number;
}

/**
 * What pushes bodies and does nothing else: a law, which is fused into the step, or a function that adds to the force
 * columns before the laws do.
 */
export interface Force {
  readonly name: string;
  /** The equation, as in the file's header. */
  readonly equation: string;
  readonly parameters?: Readonly<Record<string, ForceParameter>>;
  /** Components a body needs to feel it. */
  readonly reads: readonly string[];
  /** It reads nothing but its own body. */
  readonly local: boolean;
  /** The expressions of a law, and the values of its parameters. */
  readonly law?: Law;
  readonly sources?: readonly ParameterSource[];
  /**
   * Called once a step, before anything moves, when edits are still allowed: gathers what the force needs. What it
   * throws comes out of `step`, which then has not happened.
   */
  prepare?(world: PhysicsWorld, dt: number): void;
  /** It adds to `world.scratch.torque` as well: the torque of the last evaluation turns the bodies. */
  readonly turns?: boolean;
  /** Components whose columns its `prepare` changes, as an engine burns fuel: `limited` keeps those outside its limits. */
  readonly spends?: readonly ComponentName[];
  /**
   * Of what is no law: adds this force, N, to the force on each body of rows [first, last). `time` is that at which it
   * is evaluated, s.
   */
  accumulate?(world: PhysicsWorld, first: number, last: number, time: number): void;
  /** Potential energy of the world under this force, J; only where the force is conservative. */
  potential?(world: PhysicsWorld): number;
}

/** What a user's own force in plain TypeScript needs to say. */
export interface CustomForce {
  readonly name: string;
  readonly equation?: string;
  readonly reads?: readonly string[];
  /** Default true: reads nothing but its own body. */
  readonly local?: boolean;
  /** Default false: adds to `world.scratch.torque` as well. */
  readonly turns?: boolean;
  prepare?(world: PhysicsWorld, dt: number): void;
  accumulate(world: PhysicsWorld, first: number, last: number, time: number): void;
  potential?(world: PhysicsWorld): number;
}

/**
 * A force of your own in plain TypeScript. In `accumulate`, add newtons to `world.scratch.force.x[eid]` for each row in
 * [first, last); rows of absent bodies hold zeros and need no test.
 */
export function defineForce(force: CustomForce): Force {
  const { name, equation = '', reads = [], local = true, turns = false, accumulate, prepare, potential } = force;
  return {
    ...{ name, equation, reads, local, turns, accumulate },
    ...(prepare && { prepare }),
    ...(potential && { potential }),
  };
}
