import { createWorld, deleteWorld } from 'bitecs';
import { printWarning } from '#warnings';
import { COMPONENT_NAMES, type ComponentName, type Components } from '../components/all.ts';
import type { ComponentSpec } from '../components/define.ts';
import { identityOf } from '../ecs/bitecs/context.ts';
import { MAX_CAPACITY, nextFirstGeneration } from '../ecs/entity-ref.ts';
import { assertUsable } from '../ecs/guards.ts';
import { observeComponents } from '../ecs/observers.ts';
import { checkOwnComponents, makeOwnColumns, observeOwnComponents, ownColumnCount } from '../ecs/own-components.ts';
import { createFaultLog } from '../errors/fault-log.ts';
import { PhysicsError } from '../errors/physics-error.ts';
import { checkChoice, checkFunction, checkKeys, checkNumber, checkWhole } from '../errors/validate.ts';
import { velocityVerlet } from '../integrators/velocity-verlet.ts';
import { instantiateKernels, type Precision } from '../kernels/instantiate.ts';
import { type Arena, createArena } from '../memory/arena.ts';
import { writeColumnTable } from '../memory/column-table.ts';
import { columnCounts, componentColumns, realBytes, wordColumn } from '../memory/columns.ts';
import { FIRST_COLUMN } from '../memory/layouts.gen.ts';
import { POSE } from '../memory/previous-pose.ts';
import { createScratch, SCRATCH_COLUMNS } from '../memory/scratch.ts';
import { wallListBytes } from '../memory/wall-list.ts';
import { standard } from '../presets/standard.ts';
import { checkForces, checkIntegrator, checkSystems } from './execution-plan.ts';
import { noEdits } from './step-edits.ts';
import { createPhases } from './systems.ts';
import type { Force, Integrator, PhysicsWorld, Preset, System, Warning } from './types.ts';

/** Options of a world. All have defaults. */
export interface PhysicsWorldOptions {
  /** 2 (default) or 3. */
  readonly dimensions?: 2 | 3;
  /**
   * Maximum number of entities alive at once; fixed for the lifetime of the world. Default 10 000. Unused capacity
   * costs address space only.
   */
  readonly capacity?: number;
  /** Type of every real column: f64 (default) for orbits and large worlds, f32 for games and millions of particles. */
  readonly precision?: Precision;
  /** Seed of all random numbers in this world. Default 1. */
  readonly seed?: number;
  /** Custom components made by `defineComponent`; their columns are in the world's memory. Default none. */
  readonly components?: readonly ComponentSpec[];
  /** Default velocity Verlet. */
  readonly integrator?: Integrator;
  /** Default none. Change `world.forces` at any time. */
  readonly forces?: readonly Force[];
  /** Systems of the `walls` phase, such as `boxWalls({ … })`. Default none. */
  readonly walls?: readonly System[];
  /** Decides which systems run in which phase; default `standard`. */
  readonly preset?: Preset;
  /**
   * Reaction to a fault found in a step: 'quarantine' (default) continues without the body, 'throw' also throws at the
   * end of the step.
   */
  readonly onFault?: 'quarantine' | 'throw';
  /** Receives each warning about valid input that is probably a mistake, once. By default warnings are printed. */
  readonly onWarning?: (warning: Warning) => void;
  /**
   * Bytes of memory for features that allocate (contacts, grids). The default is 2 MiB, plus what the preset requests,
   * or 256, per entity.
   */
  readonly arenaBytes?: number;
}

/** Memory of features that does not depend on the number of bodies: trees, grids, coefficient tables. */
const DEFAULT_ARENA_BYTES = 2 ** 21;

const OPTIONS = [
  'dimensions',
  'capacity',
  'precision',
  'seed',
  'components',
  'integrator',
  'forces',
  'walls',
  'preset',
  'onFault',
  'onWarning',
  'arenaBytes',
] as const;

/**
 * Read-only, because kernels sweep the rows up to it: a larger value would lead them beyond the columns. One getter for all
 * worlds, because engines keep that of the first world with the shape of worlds, and with it whatever it refers to.
 */
const LAST_ID: PropertyDescriptor & ThisType<PhysicsWorld> = {
  get() {
    return this.internal.lastId;
  },
  enumerable: true,
};

/**
 * Creates a world synchronously. It is a bitECS world: `addEntity(world)`, `addComponent(world, eid, set(…))` and
 * `query(world, […])` work on it.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN for options; E_CAPACITY if the memory cannot be
 *   allocated
 */
export function createPhysicsWorld(options: PhysicsWorldOptions = {}): PhysicsWorld {
  checkKeys(options, 'createPhysicsWorld', OPTIONS);
  const dimensions = checkChoice(options.dimensions ?? 2, 'dimensions', [2, 3]);
  const precision = checkChoice(options.precision ?? 'f64', 'precision', ['f32', 'f64']);
  const onFault = checkChoice(options.onFault ?? 'quarantine', 'onFault', ['quarantine', 'throw']);
  const capacity = checkWhole(options.capacity ?? 10_000, 'capacity', 1, MAX_CAPACITY);
  const seed = checkWhole(options.seed ?? 1, 'seed', 0, 2 ** 53 - 1);
  const onWarning = options.onWarning ?? printWarning;
  checkFunction(onWarning, 'onWarning');
  checkFeatures(options);
  const rows = Math.ceil((capacity + 1) / 1024) * 1024;
  const { preset = standard, integrator = velocityVerlet, forces = [] } = options;
  const perEntity = preset.bytesPerEntity?.(dimensions, precision) ?? 256;
  const { arenaBytes } = options;
  const extra =
    arenaBytes === undefined
      ? DEFAULT_ARENA_BYTES + perEntity * rows
      : checkNumber(arenaBytes, 'arenaBytes', { min: 0, max: 2 ** 32 });
  const components = checkOwnComponents(options.components);
  const own = columnBytes((integrator.columns ?? 0) + ownColumnCount(components), rows, precision);
  const arena = createArena(memoryBytes(rows, precision) + own + extra, FIRST_COLUMN, extra);
  const chosen = { dimensions, precision, capacity, rows, seed, forces: [...forces], integrator, onFault, onWarning };
  const internals = createInternals(arena, precision, rows, components);
  const world = createWorld({ ...chosen, ...internals }) as object as PhysicsWorld;
  Object.defineProperty(world, 'lastId', LAST_ID);
  world.internal.bitecsIdentity = identityOf(world);
  writeColumnTable(world.memory, world.addresses, world.internal.membersAt, realBytes(world.precision));
  observeComponents(world);
  observeOwnComponents(world);
  preset(world);
  checkIntegratorKept(world, options.integrator);
  for (const system of options.walls ?? []) world.phases.walls.push(system);
  return world;
}

function checkFeatures({ dimensions = 2, forces = [], walls = [], integrator, preset }: PhysicsWorldOptions): void {
  checkForces(forces, 'forces', dimensions);
  checkSystems(walls, 'walls');
  if (integrator !== undefined) checkIntegrator(integrator, 'integrator');
  if (preset !== undefined) checkFunction(preset, 'preset');
}

/** A preset may replace the default integrator, and no other. @throws PhysicsError E_RANGE */
function checkIntegratorKept(world: PhysicsWorld, chosen: Integrator | undefined): void {
  if (chosen === undefined || world.integrator === chosen) return;
  throw new PhysicsError('E_RANGE', `this preset does not work with the integrator ${chosen.name}.`, {
    field: 'integrator',
    hint: `Leave \`integrator\` out: the preset takes ${world.integrator.name}.`,
  });
}

/** Memory for parameters of laws. */
const LOOP_BYTES = 24_576;

function memoryBytes(rows: number, precision: Precision): number {
  const { reals, words } = columnCounts();
  const realColumns = reals + SCRATCH_COLUMNS + columnCounts(POSE).reals;
  const wordColumns = words + 5;
  const columns = columnBytes(realColumns, rows, precision) + wordColumns * (rows * 4 + 8192);
  return columns + wallListBytes(rows, precision) + LOOP_BYTES + 65536;
}

/** Bytes for columns of reals, including the stagger of their start addresses in the cache. */
function columnBytes(columns: number, rows: number, precision: Precision): number {
  return columns * (rows * realBytes(precision) + 8192);
}

function createInternals(arena: Arena, precision: Precision, rows: number, own: readonly ComponentSpec[]) {
  const [components, addresses] = componentColumns(arena, precision, rows);
  const [previous, previousAddresses] = componentColumns<(typeof POSE)[number]>(arena, precision, rows, POSE);
  const scratch = createScratch(arena, precision, rows);
  const [members, membersAt] = wordColumn(arena, rows, 'members');
  const [moreMembers, moreMembersAt] = wordColumn(arena, rows, 'more members');
  const [generations] = wordColumn(arena, rows, 'generations');
  const [ids, idsAt] = wordColumn(arena, rows, 'ids');
  const [rangeWords, rangesAt] = wordColumn(arena, rows / 4, 'ranges');
  return {
    memory: arena.memory,
    kernels: instantiateKernels(precision, arena.memory),
    components,
    addresses,
    previous,
    previousAddresses,
    scratch,
    phases: createPhases(),
    time: 0,
    tick: 0,
    ranges: { bounds: new Int32Array(rangeWords.buffer, rangeWords.byteOffset, rangeWords.length), count: 0 },
    versions: { pose: 0, style: 0, membership: 0, restored: 0 },
    faults: createFaultLog(),
    profile: undefined,
    state: 'idle',
    internal: {
      arena,
      members,
      membersAt,
      moreMembers,
      moreMembersAt,
      generations,
      firstGeneration: nextFirstGeneration(),
      idsAt,
      rangesAt,
      ...initialInternals(components),
      ownComponents: makeOwnColumns(arena, precision, rows, own),
      bodyList: { ids, count: 0 },
      plan: undefined,
    },
  };
}

/** The initial internal state of a world. */
function initialInternals(components: Components) {
  const zeros = () => Object.fromEntries(COMPONENT_NAMES.map((name) => [name, 0])) as Record<ComponentName, number>;
  return {
    counts: zeros(),
    partialEntities: { immovable: 0, withoutPose: 0 },
    edits: noEdits(),
    thrown: [],
    thrownCount: 0,
    stepFaults: [],
    resources: new Map(),
    columns: COMPONENT_NAMES.flatMap((name) => Object.values(components[name]) as { [row: number]: number }[]),
    bitecsIdentity: undefined,
    justAdded: zeros(),
    checked: undefined,
    spawning: 0,
    endIfPooled: undefined,
    newParts: [],
    unobserved: new Set(),
    templates: new Map(),
    recordsContacts: false,
    ending: false,
    springTable: undefined,
    breaksSprings: false,
    isTrial: false,
    lastId: 0,
    warned: new Set(),
    reviewed: { plan: undefined, membership: -1, stepsAgo: 0 },
    rangesVersion: -1,
    leavesOutWaiting: false,
    sweptRows: 0,
    heldForces: new Set<Force>(),
  };
}

/**
 * Destroys a world: every later call on it throws E_DESTROYED, except this one, which does nothing. During a step it
 * takes effect at the end of the step. The memory is freed once nothing refers to the world or to its
 * columns: keep neither in lists, closures or layers.
 * @throws PhysicsError E_TYPE if the argument is not a world
 */
export function destroyWorld(world: PhysicsWorld): void {
  if (world?.internal !== undefined && world.state === 'destroyed') return;
  assertUsable(world);
  if (world.state !== 'idle') {
    world.internal.ending = true;
    return;
  }
  world.state = 'destroyed';
  deleteWorld(world);
}
