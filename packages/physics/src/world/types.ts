// The types of a world and its parts. They refer to each other, so they share one file, which contains no code.
import type { Query } from 'bitecs';
import type { Addresses, ComponentName, Components } from '../components/all.ts';
import type { ComponentSpec } from '../components/define.ts';
import type { Fault, FaultLog } from '../errors/fault-log.ts';
import type { Bounds } from '../errors/validate.ts';
import type { KernelExports, Precision } from '../kernels/instantiate.ts';
import type { Scalar, Vector } from '../laws/expression.ts';
import type { Arena } from '../memory/arena.ts';
import type { Previous, PreviousAddresses } from '../memory/previous-pose.ts';
import type { Scratch } from '../memory/scratch.ts';
import type { Phase, Profile } from './phases.ts';
import type { StepEdits } from './step-edits.ts';

/** Writes the numbers of a parameter into a world's memory. */
export interface ParameterSource {
  /**
   * The value is written 'once' when the law is added to a world, before every 'step', or at every 'stage' of a step,
   * at the time of the stage.
   */
  readonly when: 'once' | 'step' | 'stage';
  write(world: PhysicsWorld, into: Float64Array, at: number, time: number): void;
  /** Axes of a constant vector that are zero: terms multiplied by them are omitted from the code. */
  readonly zeros?: readonly boolean[] | undefined;
}

/** A parameter of a law. `Input` is the type of the values it accepts. */
export interface Parameter<Input = unknown> {
  readonly kind: 'scalar' | 'vector' | 'axial';
  readonly unit: string;
  readonly bounds: Bounds;
  /** Number of f64 in memory. */
  readonly size: 1 | 3;
  readonly overTime: boolean;
  /** Default value; a parameter without a default is required. */
  readonly byDefault: Input | undefined;
  /** Writes a value that the law itself supplies, not its options, such as an entity or a table address. Default none. */
  readonly supply?: ((world: PhysicsWorld, into: Float64Array, at: number) => void) | undefined;
}

/** A recorded law. */
export interface Law {
  readonly name: string;
  /** Identifies the generated code: laws of equal structure compile to the same code. */
  readonly structure: string;
  readonly parameters: readonly Parameter[];
  /** Names of the parameters, in the same order. */
  readonly names: readonly string[];
  /** Names of the columns that the law reads, by component and field. */
  readonly columns: Readonly<Record<string, string>>;
  /** Force, N. */
  readonly force?: Vector | undefined;
  /** Acceleration of every body with mass, m/s². */
  readonly acceleration?: Vector | undefined;
  /** Torque, N m. */
  readonly torque?: Vector | undefined;
  /** Potential energy of the body, J. */
  readonly potential?: Scalar | undefined;
  /** Restricts the law to worlds of these dimensions. */
  readonly dimensions?: 2 | 3 | undefined;
}

/** A parameter of a force, for its documentation. */
export interface ForceParameter {
  readonly unit: string;
  readonly value: number;
}

/**
 * A force acts on bodies and has no other effect: a law, fused into the step, or a function that adds to the force columns before.
 */
export interface Force {
  readonly name: string;
  /** The equation, as in the header of the file. */
  readonly equation: string;
  /** Its parameters, to be shown. Default none. */
  readonly parameters?: Readonly<Record<string, ForceParameter>>;
  /** Components that a body needs for the force to act on it. */
  readonly reads: readonly string[];
  /** The force on a body depends on that body only. */
  readonly local: boolean;
  /**
   * For forces that are not local: components of other bodies, beside position and velocity, on which the force on a body
   * depends. Every step checks their columns, so that a bad value of one body reaches no other. Default all.
   */
  readonly readsOfOthers?: readonly ComponentName[];
  /**
   * Work of one evaluation for all bodies, in evaluations of a simple force on one body (some 20 ns), which limits the
   * evaluations of adaptive integrators. Default 0: it is simple. A sum over pairs of bodies takes more.
   */
  evaluationWork?(world: PhysicsWorld): number;
  /** The expressions of the law. Default none: it has `accumulate`. */
  readonly law?: Law;
  /** The values of the parameters of the law. Default none. */
  readonly sources?: readonly ParameterSource[];
  /**
   * Called once per step before anything moves, while edits are still allowed, to gather the data of the force. Its
   * exceptions propagate from `step`, which then has no effect.
   */
  prepare?(world: PhysicsWorld, dt: number): void;
  /** Called when the force has left `world.forces`: gives back its memory in the world. It may be added again. */
  releaseMemory?(world: PhysicsWorld): void;
  /** The key of its memory where that changes what follows: encoded snapshots carry it to the same `form`. Default none. */
  readonly memory?: { readonly key: object; readonly form: string };
  /** The force also adds to `world.scratch.torque`; the torque of the last evaluation rotates the bodies. Default false. */
  readonly appliesTorque?: boolean;
  /**
   * Components whose columns `prepare` changes, as an engine burns fuel: `restrictForce` keeps bodies outside its
   * limits unchanged. Default none.
   */
  readonly consumes?: readonly ComponentName[];
  /**
   * For forces without a law: adds this force, N, to the force on each body of rows [first, last). `time` is the time
   * of the evaluation, s.
   */
  accumulate?(world: PhysicsWorld, first: number, last: number, time: number): void;
  /** Potential energy of the world under this force, J; present only if the force is conservative. */
  potential?(world: PhysicsWorld): number;
}

/** A recorded integration scheme. */
export interface Scheme {
  readonly structure: string;
  readonly position: Vector;
  readonly velocity: Vector;
  readonly memory: readonly Vector[];
  /** Of a scheme whose rows tell bodies apart: a `LastStepOf` of laws/last-step.ts. Default none. */
  readonly lastStep?: ((left: never) => object) | undefined;
  /** Fractions of the step at which the forces are evaluated, in order. */
  readonly stages: readonly number[];
  readonly parameters: readonly Parameter[];
  readonly sources: readonly ParameterSource[];
}

/** Evaluates all forces of the world on the bodies of `ranges` at `time` into `world.scratch.force`. */
export type EvaluateForces = (world: PhysicsWorld, ranges: Ranges, time: number) => void;

/**
 * A scheme that advances positions and velocities by one step. The state at the start is in
 * `world.previousAddresses.Position` and `world.scratch.at.startVelocity`; `stage1` and `stage2` are free.
 */
export interface Integrator {
  readonly name: string;
  /** Its parameters, to be shown. Default none. */
  readonly parameters?: Readonly<Record<string, ForceParameter>>;
  /** Order of the global error in dt. */
  readonly order: number;
  /** The energy error of a conservative system stays bounded. */
  readonly symplectic: boolean;
  /** Force evaluations per step. */
  readonly evaluations: number;
  /**
   * Fraction of a step by which the velocities lag the positions; default 0. Walls and contacts need it to find speed
   * and height at the time of impact.
   */
  readonly velocityLag?: number;
  /**
   * Returns whether a damped oscillator stays bounded: `stiffness` is ω² dt², `damping` is γ dt, for x″ = -ω² x - γ x′.
   * Springs check it before the step; without this function they do not check.
   */
  isStable?(stiffness: number, damping: number): boolean;
  /** Returns the angular frequency of contacts that are springs, in steps of `dt`, rad/s. Without it they are rigid, if any. */
  contactAngularFrequency?(dt: number): number;
  /** Number of real columns that the scheme allocates; a world created with it reserves memory for them. Default 0. */
  readonly columns?: number;
  /** Components that only the forces read elsewhere, and this scheme as well. Default none. */
  readonly reads?: readonly string[];
  /** The integrator solves springs as constraints: the force `springs()` then adds only its potential. Default false. */
  readonly solvesSprings?: boolean;
  /** The integrator holds bodies at walls itself: systems of the phase `walls` then do nothing. Default false. */
  readonly solvesWalls?: boolean;
  /** The scheme needs all bodies at once, so its steps are not split into chunks. Default false. */
  readonly wholeWorld?: boolean;
  /** Called once per step before anything moves, to allocate memory. Its exceptions propagate from `step`. */
  prepare?(world: PhysicsWorld, dt: number): void;
  /** A scheme with fixed stages as expressions, which is fused into one loop with the laws. Default none: it has `advance`. */
  readonly scheme?: Scheme;
  /** Advances the bodies by one step. It takes precedence over `scheme`. */
  advance?(world: PhysicsWorld, ranges: Ranges, dt: number, evaluateForces: EvaluateForces): void;
}

/** A system that may access the whole world. */
export interface GlobalSystem {
  (world: PhysicsWorld, dt: number): void;
  /**
   * What `decodeSnapshot` compares, as minifiers change names: `Object.assign(run, { systemName: 'score' })`. Default none: it counts.
   */
  readonly systemName?: string;
  /** Of a system in the phase `finish`: the energy that is stored in what it handles, J, which `energy` adds. Default none. */
  potential?(world: PhysicsWorld): number;
  /** Of a system in the phase `finish`: throws where it cannot be used. Called when forces, systems or the integrator changed. */
  assertWorld?(world: PhysicsWorld): void;
}

/** A system that reads and writes only the own row of each body. */
export interface LocalSystem {
  readonly name: string;
  /** Processes the rows of `ranges`. */
  run(world: PhysicsWorld, ranges: Ranges, dt: number): void;
  /** Role next to the integrator, which may fuse it into its loop: see docs/step.md. Default none: it runs by itself. */
  readonly role?: 'begin' | 'integrate' | 'rotate' | 'box' | 'check';
  /**
   * For systems of the `collide` phase: what it reads of other bodies beside position and velocity, as components or as columns such as
   * 'Collider.radius'. Every step checks these, so that a bad value of one body reaches no other. Default all by which bodies act on others.
   */
  readonly readsOfOthers?: readonly (ComponentName | `${ComponentName}.${string}`)[];
  /** The component of the entities that it handles: it is left out while there are none. Default none: it always runs. */
  readonly handles?: ComponentName;
}

/** A function that a phase of the step calls, for the whole world or for ranges of bodies. */
export type System = GlobalSystem | LocalSystem;

/** The systems of a world. Push yours to a phase; the change takes effect at the next step. */
export type Phases = { readonly [P in Phase]: System[] };

/** Fills the phases of a new world: which systems run, and in which order. */
export interface Preset {
  (world: PhysicsWorld): void;
  /** Memory that its features need, bytes per entity; replaces the default of 256. */
  readonly bytesPerEntity?: (dimensions: 2 | 3, precision: Precision) => number;
}

/** The systems of a step whose work the loops of the integrator do, because they are adjacent. */
export interface Fusion {
  /** The first loop saves the pose and validates values written between steps. */
  readonly begin: boolean;
  /** Box walls; the loop finds the bodies at the walls. */
  readonly walls: LocalSystem | undefined;
  /** The check that the last loop makes. */
  readonly check: LocalSystem | undefined;
}

/** The plan of a step, derived from phases and forces and rebuilt only when these change. */
export interface Plan {
  /** The systems of each phase when the plan was built. */
  readonly systems: Readonly<Record<Phase, readonly System[]>>;
  readonly signature: readonly unknown[];
  /** Every force depends on its own body only. */
  readonly forcesLocal: boolean;
  /** Undefined if the integrator has no fixed stages. */
  readonly fusion: Fusion | undefined;
  /** All forces are laws, and the integrator has fixed stages: the whole step is one loop. */
  readonly isOneLoop: boolean;
  /** No system runs between the one that saves the state at the start of the step and the integrator. */
  readonly isStartCurrent: boolean;
  /** Values that other parts of the engine cache with the plan, and the number of them and of their blocks of memory. */
  readonly kept: Map<object, unknown>;
  made: number;
}

/**
 * Rows to process: ascending ranges [first, last) of whole 16-row blocks. Rows in a range without a body hold zeros,
 * which every kernel leaves unchanged. After the phase `emit` there are none where entities only wait to be a particle.
 */
export interface Ranges {
  /** Pairs of first, last. */
  readonly bounds: Int32Array;
  count: number;
}

/** The checked values of a component, field by field. */
export type FieldValues = Record<string, number>;

/** The columns of one component in one world. */
export interface OwnColumns {
  readonly columns: Readonly<Record<string, { [row: number]: number; readonly length: number }>>;
  readonly addresses: Readonly<Record<string, number>>;
  /** Its bit in the second word of membership; 0 if none was left. */
  readonly bit: number;
}

export type OwnComponents = ReadonlyMap<ComponentSpec, OwnColumns>;

/** A warning about valid input that is probably a mistake. */
export interface Warning {
  readonly message: string;
  readonly hint: string;
}

/** A world: columns of numbers in one block of memory, and short lists that define a step. */
export interface PhysicsWorld {
  readonly dimensions: 2 | 3;
  readonly precision: Precision;
  readonly capacity: number;
  /** Length of every column; a multiple of 1024. Row `eid` belongs to entity `eid`; row 0 to no entity. */
  readonly rows: number;
  readonly seed: number;
  readonly memory: WebAssembly.Memory;
  readonly kernels: KernelExports;
  /** One typed array per field of each component: `world.components.Position.x[eid]`. */
  readonly components: Components;
  /** Byte addresses of the same columns, for kernels. */
  readonly addresses: Addresses;
  /** The pose of every body at the start of the last step. */
  readonly previous: Previous;
  readonly previousAddresses: PreviousAddresses;
  readonly scratch: Scratch;
  readonly phases: Phases;
  readonly forces: Force[];
  integrator: Integrator;
  onFault: 'quarantine' | 'throw';
  /** Receives each warning once; by default it is printed to the console. Production builds give no warnings. */
  onWarning: (warning: Warning) => void;
  /** Simulated time, s. */
  time: number;
  /** Number of steps completed. */
  tick: number;
  /** Highest entity id in use. */
  readonly lastId: number;
  /** Ranges of bodies, ascending. */
  readonly ranges: Ranges;
  /**
   * Counters that increase when poses, appearance or the set of bodies may have changed. Restoring a snapshot restores
   * them too; `restored` counts restores, so that the four values together never repeat.
   */
  readonly versions: { pose: number; style: number; membership: number; restored: number };
  readonly faults: FaultLog;
  profile: Profile | undefined;
  /** 'preparing' is before anything has moved, 'settling' is the end of a step, when edits made during it take effect. */
  state: 'idle' | 'preparing' | 'stepping' | 'settling' | 'destroyed';
  /** Internal state; not part of the public API. */
  readonly internal: WorldInternals;
}

/** Internal state of a world. */
export interface WorldInternals {
  readonly arena: Arena;
  /** Component bits of the entity in each row (components/membership.ts): the first word, and the second. */
  readonly members: Uint32Array;
  readonly membersAt: number;
  readonly moreMembers: Uint32Array;
  readonly moreMembersAt: number;
  /** Generation of each row: of its body, or of its plane. */
  readonly generations: Uint32Array;
  /** Added to generations in references, different in every world until it takes the state of another. */
  firstGeneration: number;
  readonly idsAt: number;
  readonly rangesAt: number;
  readonly counts: Record<ComponentName, number>;
  /** Counts of entities with mass that forces cannot move, and of those that have a velocity or spin without a pose. */
  readonly partialEntities: { immovable: number; withoutPose: number };
  /** Contacts with walls are recorded, for the contacts between bodies and for events. */
  recordsContacts: boolean;
  readonly edits: StepEdits;
  /** The first exceptions of user code in this step, and their total count. */
  readonly thrown: unknown[];
  thrownCount: number;
  /** The first 1024 faults of this step. */
  readonly stepFaults: Fault[];
  readonly resources: Map<object, unknown>;
  readonly ownComponents: OwnComponents;
  /** Every column of every component. */
  readonly columns: readonly { [row: number]: number }[];
  /** An object of bitECS's by which a reset of the world is detected. */
  bitecsIdentity: object | undefined;
  /** Per component, the entity that the running `addComponent` adds it to. */
  readonly justAdded: Record<ComponentName, number>;
  /** Values that `spawn` has validated and is about to set. */
  checked: FieldValues | undefined;
  /** Number of calls of `spawn` and `spawnMany` whose bodies are not complete: an observer of one may call the next. */
  spawning: number;
  /** Of the emitters: ends a particle whose entity is despawned, and returns whether the entity belongs to a pool. */
  endIfPooled: ((world: PhysicsWorld, eid: number) => boolean) | undefined;
  /** bitECS's queries of our components whose additions only the engine observes. */
  readonly unobserved: Set<Query>;
  /** Component values that prefabs pass to their instances. */
  readonly templates: Map<number, Partial<Record<ComponentName, FieldValues>>>;
  /** The world is destroyed at the end of this step. */
  ending: boolean;
  /** Returns the address of the record of springs, once there is one. */
  springTable: ((world: PhysicsWorld) => number) | undefined;
  /** Whether `breakSprings` has run. */
  breaksSprings: boolean;
  /** True while the integrator attempts a state that it may reject: an invalid force is not a fault then. */
  isTrial: boolean;
  /** The keys of the warnings given so far. */
  readonly warned: Set<string>;
  /** The plan and membership at the last check for warnings, and the steps since. */
  readonly reviewed: { plan: Plan | undefined; membership: number; stepsAgo: number };
  /** Entities that became parts of compound bodies since bodies/parts.ts last looked, up to `MAX_NEW_PARTS`. */
  readonly newParts: number[];
  readonly bodyList: { readonly ids: Uint32Array; count: number };
  /** The value of `world.lastId`. */
  lastId: number;
  rangesVersion: number;
  /** Whether `world.ranges` leave out what waits to be a particle, as they do after the phase `emit`. */
  leavesOutWaiting: boolean;
  /** Number of rows in use, rounded up to whole blocks. */
  sweptRows: number;
  plan: Plan | undefined;
  /** The forces of all plans so far that may hold memory. */
  readonly heldForces: Set<Force>;
}
