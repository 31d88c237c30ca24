import { entityRef, staleError } from '../ecs/entity-ref.ts';
import { assertOutsideStep, assertUsable, whenIdle } from '../ecs/guards.ts';
import { describe, PhysicsError } from '../errors/physics-error.ts';
import {
  checkChoice,
  checkFlag,
  checkKeys,
  checkNumber,
  checkWhole,
  isRecord,
  mustBe,
  readVector,
  type VectorInput,
} from '../errors/validate.ts';
import { seedWords } from '../math/random.ts';
import { BurstNumber } from '../memory/layouts.gen.ts';
import type { MemoryRecord } from '../memory/record.ts';
import { markImmutable } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import { endIfPooled, listsOf, markOver, slotOfParticle } from './early-end.ts';
import { emitParticles, emittersOf } from './emit.ts';
import { emitterKernels } from './kernels.ts';
import {
  type CheckedParameters,
  checkFollows,
  checkOptionNames,
  checkParameters,
  type EmitterOptions,
  type EmitterParameters,
  parametersOf,
} from './options.ts';
import { addressOf, type BurstPattern } from './pattern.ts';
import { type Block, layOut, makeBodies, maxBursts, removeBodies, returnBlock, takeBlock } from './pool.ts';
import { BURST_BYTES, MAX_STOPS, N, W } from './record.ts';
import type { Emitter } from './types.ts';

/**
 * Creates an emitter and the entities of all its particles. Afterwards particles are born and end in the `emit`
 * phase without adding or removing an entity and without garbage.
 *
 * Births happen at their own times between two steps, `1/rate` apart, and appear at the next step where they have
 * moved to. An inactive entity of the pool has no mass, speed, size or collider.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_STALE (entity), E_CAPACITY, E_REENTRANT (during a
 *   step), E_DESTROYED: nothing is created
 */
export function createEmitter(world: PhysicsWorld, options: EmitterOptions): Emitter {
  assertUsable(world);
  assertOutsideStep(world, 'createEmitter', IN_STEP);
  // Each option is read once, so that a getter cannot return an unchecked value later.
  const copy = isRecord(options) ? { ...options } : options;
  checkOptionNames(copy, 'createEmitter', false);
  return makeEmitter(world, copy);
}

const IN_STEP =
  'Create it before, without `rate`, and call burst(emitter, count, { position }) here; or create it after the step.';

/** A particle is a body of the world. */
const WORLD_CAPACITY =
  'The most is the capacity of the world: for more particles create the world with a larger `capacity`.';

function makeEmitter(world: PhysicsWorld, options: EmitterOptions): Emitter {
  const capacity = checkWhole(options.capacity, 'capacity', 1, world.capacity, WORLD_CAPACITY);
  checkChoice(options.whenFull ?? 'skip', 'whenFull', ['skip', 'oldest']);
  checkFollows(options);
  const parameters = markImmutable(parametersOf(options));
  const checked = checkParameters(world, parameters);
  const followed = options.entity === undefined ? undefined : entityRef(world, options.entity);
  const block = takeBlock(world, capacity, checkFlag(options.reportEndings, 'reportEndings'));
  let ids: Uint32Array;
  try {
    ids = makeBodies(world, options);
  } catch (error) {
    returnBlock(world, block);
    throw error;
  }
  initializeRecord(world, block, options, checked, ids);
  const emitter = {
    world,
    capacity,
    ids,
    internal: {
      block,
      followed,
      entity: options.entity ?? 0,
      parameters,
      bursts: new Float64Array(
        world.memory.buffer,
        block.record.words[W.bursts],
        (maxBursts(capacity) * BURST_BYTES) / 8,
      ),
      endings: undefined,
      births: undefined,
      pool: undefined,
      membership: world.versions.membership,
      destroyed: false,
      timeline: world.versions.restored,
    },
  };
  emittersOf(world).list.push(emitter);
  world.internal.endIfPooled = endIfPooled;
  if (!world.phases.emit.includes(emitParticles)) world.phases.emit.push(emitParticles);
  return emitter;
}

function initializeRecord(
  world: PhysicsWorld,
  block: Block,
  options: EmitterOptions,
  checked: CheckedParameters,
  ids: Uint32Array,
): void {
  const { record } = block;
  layOut(world, block, options.capacity);
  record.words[W.recyclesOldest] = options.whenFull === 'oldest' ? 1 : 0;
  record.words[W.emits] = 1;
  record.words[W.turns] = options.frame === 'entity' ? 1 : 0;
  record.numbers[N.turnW] = 1;
  record.numbers[N.lastTurnW] = 1;
  record.numbers[N.radius] = options.collider?.radius ?? 0;
  const stream = emittersOf(world).made++;
  seedWords(record.words.subarray(W.random0, W.random0 + 4), world.seed, stream);
  writeParameters(world, record, checked);
  record.numbers.set(checked.position, N.x);
  stopMotion(record);
  new Uint32Array(world.memory.buffer, record.words[W.ids], ids.length).set(ids);
  emitterKernels(world).openPool(record.at);
  world.versions.style++;
}

function writeParameters(world: PhysicsWorld, { at, words, numbers }: MemoryRecord, checked: CheckedParameters): void {
  const { ramps } = checked;
  numbers.set(checked.numbers, N.rate);
  numbers.set(checked.offset, N.offsetX);
  words[W.sizeStops] = checked.numbers.length - (N.size0 - N.rate);
  words[W.rampCount] = ramps.length;
  ramps.forEach((ramp, r) => {
    words.set(ramp, W.color0 + r * MAX_STOPS);
    words[W.stops0 + r] = ramp.length;
  });
  emitterKernels(world).prepareEmitter(at);
  words[W.refreshAppearance] = 1;
}

/** Sets the last position to the position, so that the emitter has no velocity. */
function stopMotion({ numbers }: MemoryRecord): void {
  numbers.copyWithin(N.lastX, N.x, N.x + 3);
}

/** @throws PhysicsError E_TYPE */
function checkEmitter(emitter: Emitter): void {
  if (emitter?.internal === undefined) throw mustBe('an emitter made by createEmitter', emitter, 'emitter');
}

/** @throws PhysicsError E_TYPE, E_DESTROYED (the world), E_STALE (the emitter) */
function recordOf(emitter: Emitter): MemoryRecord {
  checkEmitter(emitter);
  const { world, internal } = emitter;
  assertUsable(world);
  checkRestored(emitter);
  if (internal.destroyed)
    throw new PhysicsError('E_STALE', 'this emitter was destroyed. Create another with createEmitter.', {
      field: 'emitter',
    });
  return internal.block.record;
}

/** Marks the emitter destroyed if the world was restored to a time before it was created. */
function checkRestored(emitter: Emitter): void {
  const { world, internal } = emitter;
  if (internal.timeline === world.versions.restored) return;
  internal.timeline = world.versions.restored;
  if (!emittersOf(world).list.includes(emitter)) internal.destroyed = true;
}

/**
 * Changes parameters at run time, as a slider does; omitted ones stay. A new colour or size also applies to living
 * particles. A new position is moved to, see `moveEmitter`.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_STALE, E_DESTROYED: nothing is changed
 */
export function setEmitter(emitter: Emitter, changes: EmitterParameters): void {
  const record = recordOf(emitter);
  checkOptionNames(changes, 'setEmitter', true);
  if (changes.offset !== undefined && emitter.internal.followed === undefined) checkFollows(changes);
  const parameters = markImmutable({ ...emitter.internal.parameters, ...parametersOf(changes) });
  const checked = checkParameters(emitter.world, parameters);
  emitter.internal.parameters = parameters;
  writeParameters(emitter.world, record, checked);
  if (changes.position !== undefined) record.numbers.set(checked.position, N.x);
}

/**
 * Sets the number of births per second.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_STALE, E_DESTROYED
 */
export function setRate(emitter: Emitter, rate: number): void {
  setEmitter(emitter, { rate });
}

/**
 * Moves the emitter. The births until the next step are spread along the path, and inherit its velocity; with `jump`
 * the emitter has no path. An emitter that follows a body is always at the body.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_STALE, E_DESTROYED
 */
export function moveEmitter(emitter: Emitter, position: VectorInput, jump = false): void {
  setEmitter(emitter, { position });
  if (jump) stopMotion(emitter.internal.block.record);
}

/** Options of a single burst. */
export interface BurstOptions {
  /** Position, m; default the position of the emitter. */
  readonly position?: VectorInput;
  /** Added to each particle's velocity, m/s. Default 0. */
  readonly velocity?: VectorInput;
  /** Index of the emitter's colour ramp; by default each particle draws a ramp. */
  readonly ramp?: number;
  /** The velocities of its particles in turn, instead of the emitter's speed and direction. Default none. */
  readonly pattern?: BurstPattern | undefined;
  /** Factor of the pattern's velocities. Default 1. */
  readonly scale?: number;
}

/**
 * Creates `count` particles at once, at the next step.
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_UNKNOWN, E_STALE, E_DESTROYED; E_CAPACITY beyond
 *   the maximum of bursts per step, which is the capacity of the emitter, but at least 64 and at most 256
 */
export function burst(emitter: Emitter, count: number, options: BurstOptions = NO_OPTIONS): void {
  const { words } = recordOf(emitter);
  const { world, internal, capacity } = emitter;
  checkWhole(count, 'count', 0, capacity);
  checkKeys(options, 'burst', BURST_OPTIONS);
  const { ramp = -1, pattern, scale = 1, position = NO_OPTIONS, velocity = NO_OPTIONS } = options;
  checkWhole(ramp, 'ramp', -1, words[W.rampCount] - 1);
  checkNumber(scale, 'scale', SCALE_BOUNDS);
  const velocities = pattern === undefined ? 0 : addressOf(world, pattern);
  const pendingCount = words[W.burstCount];
  if (pendingCount >= maxBursts(capacity)) {
    throw new PhysicsError(
      'E_CAPACITY',
      `the emitter already has ${pendingCount} bursts pending, the maximum per step. Call step, or merge bursts.`,
      { field: 'burst', value: count },
    );
  }
  const { bursts } = internal;
  const start = (pendingCount * BURST_BYTES) / 8;
  readVector(bursts, start + BurstNumber.x, position, 'position', POSITION_BOUNDS);
  readVector(bursts, start + BurstNumber.velocityX, velocity, 'velocity', VELOCITY_BOUNDS);
  const z = bursts[start + BurstNumber.z] === 0 ? bursts[start + BurstNumber.velocityZ] : bursts[start + BurstNumber.z];
  if (world.dimensions === 2 && z !== 0) checkNumber(z, 'burst z', { min: 0, max: 0 });
  bursts[start + BurstNumber.count] = count;
  bursts[start + BurstNumber.placed] = options.position === undefined ? 0 : 1;
  bursts[start + BurstNumber.ramp] = ramp;
  bursts[start + BurstNumber.pattern] = velocities;
  bursts[start + BurstNumber.patternCount] = pattern?.count ?? 0;
  bursts[start + BurstNumber.scale] = scale;
  words[W.burstCount] = pendingCount + 1;
}

const BURST_OPTIONS = ['ramp', 'pattern', 'scale', 'position', 'velocity'];
const NO_OPTIONS = {};
const SCALE_BOUNDS = { min: -1e6, max: 1e6 };
const POSITION_BOUNDS = { min: -1e15, max: 1e15 };
const VELOCITY_BOUNDS = { min: -1e9, max: 1e9 };

/**
 * Ends one particle before its time, at the beginning of the next step: before anything moves, as one whose life is over. It
 * counts as ended, is among `endings`, and its place is free for the next birth. During a step, in handlers and systems, too.
 * `despawn` of a particle does the same. A second call has no effect.
 * @throws PhysicsError E_STALE if the id is that of no living particle of this emitter, or the emitter was destroyed;
 *   E_TYPE, E_DESTROYED
 */
export function endParticle(emitter: Emitter, id: number): void {
  recordOf(emitter);
  const slot = slotOfParticle(emitter, id);
  if (slot < 0) {
    throw staleError(id, `${describe(id)} is no living particle of this emitter: it may have ended already.`, LIVING);
  }
  markOver(emitter, slot);
}

const LIVING = 'Its living particles are those of emitter.ids with a mass.';

/** Returns the number of living particles. @throws PhysicsError E_STALE, E_DESTROYED */
export function aliveCount(emitter: Emitter): number {
  return recordOf(emitter).words[W.alive];
}

/** Numbers of particles since the emitter was created. */
export interface EmitterCounts {
  readonly alive: number;
  readonly born: number;
  readonly ended: number;
  /** Births that were dropped because the pool was full. Those whose life ends before they would appear need no room. */
  readonly dropped: number;
}

/**
 * How many particles an emitter has made, has alive and has dropped.
 * @throws PhysicsError E_STALE, E_DESTROYED
 */
export function emitterCounts(emitter: Emitter): EmitterCounts {
  const { words, numbers } = recordOf(emitter);
  return { alive: words[W.alive], born: numbers[N.born], ended: numbers[N.ended], dropped: numbers[N.droppedCount] };
}

/**
 * Particles that ended in the last step. One whose whole life fell between two steps had no entity and is not among them, nor are
 * more than the capacity of the emitter, which `burst` may replace in a step with `whenFull: 'oldest'`; `emitterCounts` has all.
 */
export interface Endings {
  readonly count: number;
  /** Ids of pool entities, which may be in use again; only the first `count` are valid. */
  readonly ids: Uint32Array;
  /** Six numbers per particle: final position x, y, z, m, and velocity, m/s. */
  readonly states: Float64Array;
}

/**
 * Returns the particles that ended in the last step and where, for example to burst shells. Needs `reportEndings`.
 * It is the same object on every call, overwritten by each step.
 * @throws PhysicsError E_RANGE without `reportEndings`, E_STALE, E_DESTROYED
 */
export function endings(emitter: Emitter): Endings {
  const { words } = recordOf(emitter);
  if (words[W.endedIds] === 0) {
    throw new PhysicsError('E_RANGE', 'this emitter does not report endings.', {
      field: 'reportEndings',
      hint: 'Make it with `reportEndings: true`.',
    });
  }
  const { world, capacity, internal } = emitter;
  const { buffer } = world.memory;
  internal.endings ??= {
    count: 0,
    ids: new Uint32Array(buffer, words[W.endedIds], capacity),
    states: new Float64Array(buffer, words[W.endedAt], 6 * capacity),
  };
  internal.endings.count = words[W.endedThisStep];
  return internal.endings;
}

/** Particles that were born in the last step. */
export interface Births {
  readonly count: number;
  /** Ids in the order of birth; only the first `count` are valid. */
  readonly ids: Uint32Array;
}

/**
 * Returns the particles that were born in the last step, to give them data of your own. A system of the phase `begin` reads
 * those of its own step before anything moves them. It is the same object on every call, filled by each.
 * @throws PhysicsError E_STALE, E_DESTROYED
 */
export function births(emitter: Emitter): Births {
  const { words } = recordOf(emitter);
  const { world, capacity, internal } = emitter;
  internal.births ??= { count: 0, ids: new Uint32Array(capacity) };
  const pool = listsOf(emitter);
  const { births: found } = internal;
  found.count = 0;
  let slot = words[W.newest];
  for (let left = words[W.newborns]; left > 0 && slot !== NO_SLOT; left--, slot = pool.older[slot]) {
    const id = pool.ids[slot];
    if (pool.generation[slot] === world.internal.generations[id]) found.ids[found.count++] = id;
  }
  found.ids.subarray(0, found.count).reverse();
  return found;
}

/** Ends the list of the living: NONE of kernels/emitters/pool.ts. */
const NO_SLOT = 0xffffffff;

/**
 * Removes the emitter and all entities of its pool; during a step, when the step ends. A second call has no effect.
 * @throws PhysicsError E_DESTROYED
 */
export function destroyEmitter(emitter: Emitter): void {
  checkEmitter(emitter);
  const { world, internal } = emitter;
  assertUsable(world);
  whenIdle(world, () => {
    checkRestored(emitter);
    if (internal.destroyed) return;
    internal.destroyed = true;
    const { list } = emittersOf(world);
    list.splice(list.indexOf(emitter), 1);
    removeBodies(world, internal.block.record);
    returnBlock(world, internal.block);
  });
}
