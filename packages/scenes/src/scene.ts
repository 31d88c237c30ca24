import { type Integrator, PhysicsError, type PhysicsWorld, type Precision, type Progress } from '@principia/physics';

/** A number a scene is made with. */
export interface SceneParameter {
  readonly about: string;
  /** SI unit; empty for a pure number. */
  readonly unit: string;
  /** The value when none is given. */
  readonly initial: number;
  readonly min: number;
  readonly max: number;
  readonly integer?: boolean;
}

/** What every scene takes besides its own parameters. */
export interface SceneOptions {
  /** How many; what is counted the scene's parameter `count` says. */
  readonly count?: number;
  readonly dimensions?: 2 | 3;
  readonly precision?: Precision;
  /** Equal seeds and parameters give equal worlds. */
  readonly seed?: number;
  /** The scheme it moves by; default the scene's own choice. */
  readonly integrator?: Integrator;
  /** Called as bodies are made. */
  readonly progress?: Progress;
}

/** The worst of all and the root of their mean square. */
export interface Stretch {
  readonly worst: number;
  readonly rms: number;
}

/** Two fresh worlds of the same bodies, one by the scheme of the scene and one by the reference. */
export interface ReferenceRuns {
  /** The scheme that is next to exact. */
  readonly name: string;
  /** Times to go to one after the other, s. */
  readonly times: readonly number[];
  /** Names of some of these times. */
  readonly labels: ReadonlyMap<number, string>;
  /** Moves one of the two to a time. */
  readonly ours: (time: number) => void;
  readonly theirs: (time: number) => void;
  /** How far apart they have each body, km, at the time both have come to. */
  readonly apartKm: () => Readonly<Record<string, number>>;
}

/** A scene made: a world and how to move it on. */
export interface SceneRun {
  readonly world: PhysicsWorld;
  /** Length of a step the scene is meant for, s. */
  readonly dt: number;
  /** Moves the scene by one step; absent where that is `step(world, dt)`. */
  readonly advance?: (world: PhysicsWorld) => void;
  /** RMS relative error of forces that are approximated, as they are now; absent where they are exact. */
  readonly forceError?: (world: PhysicsWorld) => number;
  /** How far what should keep its length is from it as it is now, by that length; absent where nothing has to. */
  readonly stretch?: (world: PhysicsWorld) => Stretch;
  /** Distance of each body from where it should be, km, by body and time, of a run of its own; absent where unknown. */
  readonly errorKm?: () => Readonly<Record<string, Readonly<Record<string, number>>>>;
  /** The same by a scheme that is next to exact, from the start anew; absent where there is none to compare with. */
  readonly reference?: () => ReferenceRuns;
  /** Why the energy of this scene is not constant; absent where it is. */
  readonly losesEnergy?: string;
}

/** The checked numbers a scene is built from. */
export interface Setup<Name extends string> {
  readonly dimensions: 2 | 3;
  readonly precision: Precision;
  readonly seed: number;
  /** The scheme asked for. A scene that does not look at it is given it afterwards. */
  readonly integrator: Integrator | undefined;
  readonly progress: Progress | undefined;
  readonly parameters: Readonly<Record<Name | 'count', number>>;
}

/** What a scene's file says of it. */
export interface SceneSpec<Name extends string, Run extends SceneRun = SceneRun> {
  readonly name: string;
  /** One line. */
  readonly description: string;
  /** The precision when none is given; default f64. */
  readonly precision?: Precision;
  readonly parameters: Readonly<Record<Name | 'count', SceneParameter>>;
  build(setup: Setup<Name>): Run;
}

export interface Scene<Name extends string = never, Run extends SceneRun = SceneRun> {
  readonly name: string;
  readonly description: string;
  /** The precision it is made in when none is given. */
  readonly precision: Precision;
  readonly parameters: Readonly<Record<Name | 'count', SceneParameter>>;
  /** @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN */
  create(options?: SceneOptions & { readonly [Parameter in Name]?: number }): Run;
}

const COMMON = ['dimensions', 'precision', 'seed', 'integrator', 'progress'];

/** A scene from its description: checks what it is made with, so that `build` need not. */
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
 * The value of a parameter: the given one where it is valid, the initial one where none is given.
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

/** How many there are of what a scene is made of. */
export function countOf(about: string, initial: number, max: number, min = 1): SceneParameter {
  return { about, unit: '', initial, min, max, integer: true };
}
