// The contract that everything types against: what a world is, and what can be put into it. These types name each other,
// so they stand in one file; nothing here runs.
import type { Query, WorldContext } from 'bitecs';
import type { Addresses, ComponentName, Components } from '../components/all.ts';
import type { ComponentSpec } from '../components/define.ts';
import type { Fault, FaultLog } from '../errors/fault-log.ts';
import type { Bounds } from '../errors/validate.ts';
import type { KernelExports, Precision } from '../kernels/instantiate.ts';
import type { Scalar, Vector } from '../laws/expression.ts';
import type { Arena } from '../memory/arena.ts';
import type { Previous, PreviousAddresses } from '../memory/previous-pose.ts';
import type { Scratch } from '../memory/scratch.ts';
import type { Phase } from './phases.ts';

/** How the numbers of a parameter get into a world's memory. */
export interface ParameterSource {
  /** 'once' when the law enters a world, before every 'step', or for every 'stage' of one, at its time. */
  readonly when: 'once' | 'step' | 'stage';
  write(world: PhysicsWorld, into: Float64Array, at: number, time: number): void;
  /** Axes of a steady vector that are zero: what they are multiplied by is left out of the code. */
  readonly zeros?: readonly boolean[] | undefined;
}

/** A parameter of a law. `Input` is the type of what it takes. */
export interface Parameter<Input = unknown> {
  readonly kind: 'scalar' | 'vector' | 'axial';
  readonly unit: string;
  readonly bounds: Bounds;
  /** Number of doubles it takes in memory. */
  readonly size: 1 | 3;
  readonly overTime: boolean;
  /** What it is when it is left out; without one it must be given. */
  readonly byDefault: Input | undefined;
  /** It comes from the law itself and not from its options: which body is held, where a table lies. */
  readonly supply?: ((world: PhysicsWorld, into: Float64Array, at: number) => void) | undefined;
}

/** A recorded law. */
export interface Law {
  readonly name: string;
  /** The same for laws that compile to the same code. */
  readonly structure: string;
  readonly parameters: readonly Parameter[];
  /** Their names, in the same order. */
  readonly names: readonly string[];
  /** What the law calls the columns that it reads, by component and field. */
  readonly columns: Readonly<Record<string, string>>;
  /** Force, N. */
  readonly force?: Vector | undefined;
  /** Acceleration of every body with mass, m/s². */
  readonly acceleration?: Vector | undefined;
  /** Torque, N m. */
  readonly torque?: Vector | undefined;
  /** Potential energy of the body, J. */
  readonly potential?: Scalar | undefined;
  /** It is for worlds of these dimensions alone. */
  readonly dimensions?: 2 | 3 | undefined;
}

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
  readonly appliesTorque?: boolean;
  /** Components whose columns its `prepare` changes, as an engine burns fuel: `restrictForce` keeps those outside its limits. */
  readonly consumes?: readonly ComponentName[];
  /**
   * Of what is no law: adds this force, N, to the force on each body of rows [first, last). `time` is that at which it
   * is evaluated, s.
   */
  accumulate?(world: PhysicsWorld, first: number, last: number, time: number): void;
  /** Potential energy of the world under this force, J; only where the force is conservative. */
  potential?(world: PhysicsWorld): number;
}

/** A recorded scheme. */
export interface Scheme {
  readonly structure: string;
  readonly position: Vector;
  readonly velocity: Vector;
  readonly memory: readonly Vector[];
  /** Fractions of the step at which the forces are evaluated, in order. */
  readonly stages: readonly number[];
  readonly parameters: readonly Parameter[];
  readonly sources: readonly ParameterSource[];
}

/** Evaluates all forces of the world on the bodies of `ranges` at `time`, into `world.scratch.force`. */
export type EvaluateForces = (world: PhysicsWorld, ranges: Ranges, time: number) => void;

/**
 * A scheme that moves positions and velocities by one step. It owns the step: it asks for forces when it wants them.
 * The state at the start is in `world.previousAddresses.Position` and `world.scratch.at.startVelocity`; `stage1` and
 * `stage2` of the scratch are free.
 */
export interface Integrator {
  readonly name: string;
  /** Order of the global error in dt. */
  readonly order: number;
  /** Keeps the energy of a conservative system bounded for ever. */
  readonly symplectic: boolean;
  /** Force evaluations a step. */
  readonly evaluations: number;
  /**
   * By what part of a step its velocities are those of an earlier moment than its positions; default 0. Walls and
   * contacts need it to find speed and height at the instant of an impact.
   */
  readonly velocityLag?: number;
  /**
   * Whether a damped oscillator stays bounded: `stiffness` is ω² dt², `damping` is γ dt, for x″ = -ω² x - γ x′. Springs
   * ask before the step; without an answer they do not check.
   */
  isStable?(stiffness: number, damping: number): boolean;
  /** Columns of reals it takes from the world's memory; a world made with it has room for them. */
  readonly columns?: number;
  /** It solves springs itself, as constraints: the force `springs()` then adds nothing but its potential. */
  readonly solvesSprings?: boolean;
  /** It must see all bodies at once, so that no step of it runs tile by tile. */
  readonly wholeWorld?: boolean;
  /** Called once a step, before anything moves: takes memory. What it throws comes out of `step`. */
  prepare?(world: PhysicsWorld, dt: number): void;
  /** A scheme of fixed stages as expressions: it becomes one loop with the laws. */
  readonly scheme?: Scheme;
  /** Moves the bodies by one step. Where there is one, the scheme is not used. */
  advance?(world: PhysicsWorld, ranges: Ranges, dt: number, evaluateForces: EvaluateForces): void;
}

/** A system that may look at the whole world. */
export type GlobalSystem = (world: PhysicsWorld, dt: number) => void;

/** A system that, for each body, reads and writes the body's own row only. */
export interface LocalSystem {
  readonly name: string;
  /** Sweeps the runs of `ranges`. */
  run(world: PhysicsWorld, ranges: Ranges, dt: number): void;
  /** What it is to the integrator, when that may take over its work: see docs/step.md. */
  readonly role?: 'begin' | 'integrate' | 'rotate' | 'box' | 'check';
}

export type System = GlobalSystem | LocalSystem;

/** The systems of a world. Push yours to a phase; the change takes effect at the next step. */
export type Phases = { readonly [P in Phase]: System[] };

/** Fills a new world's phases: which systems run, in which order. */
export interface Preset {
  (world: PhysicsWorld): void;
  /** Memory its features need, bytes an entity: what a world then has by default in place of 256. */
  readonly bytesPerEntity?: (dimensions: 2 | 3, precision: Precision) => number;
}

/** What of a step runs as one loop with the laws and the integrator, because the systems follow each other. */
export interface Fusion {
  /** The pose is saved, and what was written between the steps is checked. */
  readonly begin: boolean;
  /** Walls of a box, at which bodies are found in the loop. */
  readonly walls: LocalSystem | undefined;
  /** The result is checked. */
  readonly check: boolean;
}

/** What a step does, worked out from the phases and forces; made anew only when those change. */
export interface Plan {
  /** The systems of each phase, as they were when the plan was made. */
  readonly systems: Readonly<Record<Phase, readonly System[]>>;
  readonly signature: readonly unknown[];
  /** No force looks at more than its own body. */
  readonly forcesLocal: boolean;
  /** Undefined where a force is no law, or the integrator has no fixed stages. */
  readonly fusion: Fusion | undefined;
  /** What other parts of the engine keep as long as the plan holds. */
  readonly kept: Map<object, unknown>;
}

/** Time spent in each phase since the profile was switched on or reset, in the clock's unit. */
export interface Profile {
  readonly clock: () => number;
  readonly times: Record<Phase, number>;
}

/**
 * Rows to sweep: ascending runs [first, last) of whole 16-row blocks. Rows in a run that belong to no body hold zeros,
 * which every kernel leaves as they are.
 */
export interface Ranges {
  /** Pairs first, last. */
  readonly bounds: Int32Array;
  count: number;
}

/** The checked values of a component, field by field. */
export type FieldValues = Record<string, number>;

/** The columns of one component in one world. */
export interface OwnColumns {
  readonly columns: Readonly<Record<string, { [row: number]: number; readonly length: number }>>;
  readonly addresses: Readonly<Record<string, number>>;
}

export type OwnComponents = ReadonlyMap<ComponentSpec, OwnColumns>;

/** Legal input that is surely not meant. */
export interface Warning {
  readonly message: string;
  readonly hint: string;
}

/** A world: plain columns of numbers in one block of memory, and the short lists that say what a step does. */
export interface PhysicsWorld {
  readonly dimensions: 2 | 3;
  readonly precision: Precision;
  readonly capacity: number;
  /** Length of every column; a multiple of 1024. Row `eid` belongs to entity `eid`; row 0 to none. */
  readonly rows: number;
  readonly seed: number;
  readonly memory: WebAssembly.Memory;
  readonly kernels: KernelExports;
  /** Per component, one typed array a field: `world.components.Position.x[eid]`. */
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
  /** Receives each warning once; by default it is printed to the console. Builds for production give none. */
  onWarning: (warning: Warning) => void;
  /** Simulated time, s. */
  time: number;
  /** Steps done. */
  tick: number;
  /** Highest entity id in use. */
  lastId: number;
  /** Runs of bodies, ascending. */
  readonly ranges: Ranges;
  /**
   * Counters that grow when poses, looks or the set of bodies may have changed. A snapshot brings them back too;
   * `restored` counts how often that happened, so that the four together never repeat.
   */
  readonly versions: { pose: number; style: number; membership: number; restored: number };
  readonly faults: FaultLog;
  profile: Profile | undefined;
  /** 'preparing' is before anything has moved, 'settling' is the end of a step, when the edits made during it take effect. */
  state: 'idle' | 'preparing' | 'stepping' | 'settling' | 'destroyed';
  /** Not for users. */
  readonly internal: WorldInternals;
}

/** What the engine keeps about a world. */
export interface WorldInternals {
  readonly arena: Arena;
  /** Bit set per row: the components its entity has. */
  readonly members: Uint32Array;
  readonly membersAt: number;
  /** Lives per row. */
  readonly generations: Uint32Array;
  readonly idsAt: number;
  readonly rangesAt: number;
  readonly counts: Record<ComponentName, number>;
  /** Entities with mass that forces cannot move, and such as move without a place or turn without an angle. */
  readonly partialEntities: { unmoved: number; strays: number };
  /** Edits made during a step, waiting for its end. */
  readonly deferredEdits: (() => void)[];
  /** Entities that end with this step, and by bitECS's own set of components which life of theirs it is. */
  readonly leaving: Map<number, Set<unknown>>;
  /** Exceptions of users' code during this step: the first few, and how many there were. */
  readonly thrown: unknown[];
  thrownCount: number;
  /** Faults of this step, the first 1024. */
  readonly stepFaults: Fault[];
  readonly resources: Map<object, unknown>;
  readonly ownComponents: OwnComponents;
  /** Every column of every component. */
  readonly columns: readonly { [row: number]: number }[];
  /** bitECS's table of components, to notice that the world was reset. */
  componentMap: WorldContext['componentMap'] | undefined;
  /** Per component, the entity that the `addComponent` now running gave it to. */
  readonly justAdded: Record<ComponentName, number>;
  /** Values that `spawn` has checked and is about to set. */
  checked: FieldValues | undefined;
  /** bitECS's queries of our components whose additions nobody but us waits for. */
  readonly unobserved: Set<Query>;
  /** What prefabs hand on to their instances. */
  readonly templates: Map<number, Partial<Record<ComponentName, FieldValues>>>;
  /** The world ends with this step. */
  ending: boolean;
  /** The integrator tries a state that it may reject: a bad force there is no fault. */
  isTrial: boolean;
  /** Messages of the warnings that were given. */
  readonly warned: Set<string>;
  /** What the world was last checked with for warnings. */
  readonly reviewed: { plan: Plan | undefined; membership: number };
  readonly bodyList: { readonly ids: Uint32Array; count: number };
  rangesVersion: number;
  /** Rows that hold anything, rounded up to whole blocks. */
  sweptRows: number;
  plan: Plan | undefined;
}
