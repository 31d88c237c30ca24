import { type Integrator, PhysicsError, type PhysicsWorld, type Precision, type Progress } from '@principia/physics';

/** A numeric parameter of a scene. */
export interface SceneParameter {
  /** What it is, in a few words. */
  readonly about: string;
  /** SI unit; empty for a dimensionless number. */
  readonly unit: string;
  /** The default value. */
  readonly initial: number;
  readonly min: number;
  readonly max: number;
  /** Whether only integers are allowed. Default false. */
  readonly integer?: boolean;
}

/** Options that all scenes share. */
export interface SceneOptions {
  /** Number of bodies; the scene's parameter `count` says which bodies. Default the `initial` of that parameter. */
  readonly count?: number;
  /** Default 2; scenes of rigid bodies have no other. */
  readonly dimensions?: 2 | 3;
  /** Default that of the scene, mostly f32. */
  readonly precision?: Precision;
  /** Equal seeds and parameters give equal worlds. Default 1. */
  readonly seed?: number;
  /**
   * Replaces the scene's default integrator. Of one of the same name the scene's own is taken, with the scene's parameters, such as the
   * sub-steps of a cloth. Scenes of rigid bodies take any `softStep({ … })`, which then decides whether bodies sleep, and refuse other
   * integrators: E_RANGE.
   */
  readonly integrator?: Integrator;
  /** Called while bodies are created. Default none. */
  readonly progress?: Progress;
}

/** Maximum and root mean square of the relative stretch. */
export interface Stretch {
  readonly worst: number;
  readonly rms: number;
}

/** Two new worlds with the same bodies, one with the scene's integrator and one with the reference. */
export interface ReferenceRuns {
  /** Name of the reference integrator, which is nearly exact. */
  readonly name: string;
  /** Times to compare, ascending, s. */
  readonly times: readonly number[];
  /** Names of some of these times. */
  readonly labels: ReadonlyMap<number, string>;
  /** Advances one of the two worlds to a time. */
  readonly ours: (time: number) => void;
  readonly theirs: (time: number) => void;
  /** Distance between the two solutions for each body, km, at the time both have reached. */
  readonly apartKm: () => Readonly<Record<string, number>>;
}

/** A scene that was built: a world and its time step. */
export interface SceneRun {
  readonly world: PhysicsWorld;
  /** The time step for which the scene was designed, s. */
  readonly dt: number;
  /** Advances the scene by one step; absent if that is `step(world, dt)`. */
  readonly advance?: (world: PhysicsWorld) => void;
  /** RMS relative error of approximated forces in the present state; absent if forces are exact. */
  readonly forceError?: (world: PhysicsWorld) => number;
  /** Relative deviation of inextensible threads from their length; absent if there are none. */
  readonly stretch?: (world: PhysicsWorld) => Stretch;
  /** Distance of each body from its true position, km, by body and time, in a separate run; absent if unknown. */
  readonly errorKm?: () => Readonly<Record<string, Readonly<Record<string, number>>>>;
  /** A comparison with a nearly exact integrator from the initial state; absent if there is none. */
  readonly reference?: () => ReferenceRuns;
  /** Why the energy of this scene is not conserved; absent if it is. */
  readonly losesEnergy?: string;
}

/** The validated parameters from which a scene is built. */
export interface Setup<Name extends string> {
  readonly dimensions: 2 | 3;
  readonly precision: Precision;
  readonly seed: number;
  /** The requested integrator. If the scene ignores it, `defineScene` sets it afterwards. */
  readonly integrator: Integrator | undefined;
  readonly progress: Progress | undefined;
  readonly parameters: Readonly<Record<Name | 'count', number>>;
}

/** The definition of a scene. */
export interface SceneSpec<Name extends string, Run extends SceneRun = SceneRun> {
  readonly name: string;
  /** One line. */
  readonly description: string;
  /** Default precision; f64 if omitted. */
  readonly precision?: Precision;
  readonly parameters: Readonly<Record<Name | 'count', SceneParameter>>;
  build(setup: Setup<Name>): Run;
}

/** A world that can be built from parameters, for games, tests and measurements. `SCENES` lists all. */
export interface Scene<Name extends string = never, Run extends SceneRun = SceneRun> {
  /** The name by which `findScene` finds it. */
  readonly name: string;
  /** One line. */
  readonly description: string;
  /** Default precision. */
  readonly precision: Precision;
  /** The parameters that `create` takes besides `SceneOptions`. */
  readonly parameters: Readonly<Record<Name | 'count', SceneParameter>>;
  /**
   * Builds a new world.
   * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN
   */
  create(options?: SceneOptions & { readonly [Parameter in Name]?: number }): Run;
}

const COMMON = ['dimensions', 'precision', 'seed', 'integrator', 'progress'];

/** Makes a scene from its definition: validates the options, so that `build` need not. */
export function defineScene<Name extends string, Run extends SceneRun>(spec: SceneSpec<Name, Run>): Scene<Name, Run> {
  const names = Object.keys(spec.parameters) as (Name | 'count')[];
  return {
    name: spec.name,
    description: spec.description,
    precision: spec.precision ?? 'f64',
    parameters: spec.parameters,
    create(options = {}) {
      const given = options as Record<string, unknown>;
      for (const key of Object.keys(given)) {
        if (COMMON.includes(key) || (names as string[]).includes(key)) continue;
        throw new PhysicsError('E_UNKNOWN', `the scene ${spec.name} has no parameter "${key}".`, {
          field: key,
          hint: `Valid: ${[...names, ...COMMON].join(', ')}.`,
        });
      }
      const { dimensions = 2, precision = spec.precision ?? 'f64', seed = 1, integrator, progress } = options;
      const values = names.map((name) => [name, checkParameter(name, spec.parameters[name], given[name])]);
      const parameters = Object.fromEntries(values) as Record<Name | 'count', number>;
      const run = spec.build({ dimensions, precision, seed, integrator, progress, parameters });
      if (integrator !== undefined && run.world.integrator.name !== integrator.name) run.world.integrator = integrator;
      return run;
    },
  };
}

/**
 * Validates a parameter; returns its default if no value is given.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function checkParameter(name: string, parameter: SceneParameter, value: unknown): number {
  if (value === undefined) return parameter.initial;
  const details = { field: name, value };
  if (typeof value !== 'number') {
    throw new PhysicsError('E_TYPE', `${name} must be a number, got ${typeof value}.`, details);
  }
  if (!Number.isFinite(value)) throw new PhysicsError('E_NONFINITE', `${name} must be finite, got ${value}.`, details);
  const { min, max, integer = false } = parameter;
  if (value < min || value > max || (integer && !Number.isInteger(value))) {
    const kind = integer ? 'a whole number ' : '';
    throw new PhysicsError('E_RANGE', `${name} must be ${kind}from ${min} to ${max}, got ${value}.`, details);
  }
  return value;
}

/** A parameter that counts bodies or other objects. */
export function countOf(about: string, initial: number, max: number, min = 1): SceneParameter {
  return { about, unit: '', initial, min, max, integer: true };
}
