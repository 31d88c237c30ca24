// The memory and the entities of an emitter's pool.

import { spawnMany } from '../bodies/spawn-many.ts';
import { bitOf } from '../components/membership.ts';
import { removeEntityCompletely } from '../ecs/bitecs/remove-entity.ts';
import { NO_GENERATION } from '../ecs/entity-ref.ts';
import { checkFlag } from '../errors/validate.ts';
import { allocate } from '../memory/arena.ts';
import { writeWaiting } from '../memory/column-table.ts';
import { wordColumn } from '../memory/columns.ts';
import { type MemoryRecord, recordAt } from '../memory/record.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { EmitterOptions } from './options.ts';
import { BURST_BYTES, EMITTER_BYTES, MAX_RAMPS, W } from './record.ts';

/** The maximum number of bursts in a step for an emitter of this capacity. */
export function maxBursts(capacity: number): number {
  return Math.min(256, Math.max(64, capacity));
}

/** A lookup table of 256 colours per ramp. */
const COLOR_BYTES = MAX_RAMPS * 1024;
const SLOT_BYTES = 40;
const ENDING_BYTES = 52;

/** A block of the world's memory for an emitter; it is reused after the emitter is destroyed. */
export interface Block {
  readonly record: MemoryRecord;
  readonly capacity: number;
  readonly reports: boolean;
}

/** Free blocks of destroyed emitters: the world's memory is never released. */
const idleBlocks = namedResource('idle emitter blocks', (): Block[] => []);

/** The column in which kernels/emitters/pool.ts notes what waits to be a particle. */
const waitingColumn = namedResource('waiting particles', ({ internal, memory, rows }) => {
  const [, at] = wordColumn(internal.arena, rows, 'waiting particles');
  writeWaiting(memory, internal.generations.byteOffset, at);
  return { at };
});

/** @throws PhysicsError E_CAPACITY */
export function takeBlock(world: PhysicsWorld, capacity: number, reports: boolean): Block {
  waitingColumn(world);
  const freeBlocks = idleBlocks(world);
  const fits = (block: Block) =>
    block.capacity >= capacity && block.capacity <= 2 * capacity + 64 && block.reports === reports;
  const found = freeBlocks.findIndex(fits);
  if (found >= 0) return freeBlocks.splice(found, 1)[0];
  const { arena } = world.internal;
  const slots = capacity * (SLOT_BYTES + (reports ? ENDING_BYTES : 0));
  const bytes = EMITTER_BYTES + maxBursts(capacity) * BURST_BYTES + COLOR_BYTES + slots;
  const at = allocate(arena, bytes + 64, `an emitter of ${capacity} particles`);
  return { record: recordAt(arena.memory, at, EMITTER_BYTES), capacity, reports };
}

export function returnBlock(world: PhysicsWorld, block: Block): void {
  idleBlocks(world).push(block);
}

/** Lays out the block's arrays for `capacity` slots, the arrays of 8 bytes per slot first. */
export function layOut(world: PhysicsWorld, { record, reports }: Block, capacity: number): void {
  const { words } = record;
  let top = record.at + EMITTER_BYTES;
  const allocateBytes = (bytes: number) => {
    top += bytes;
    return top - bytes;
  };
  words.fill(0);
  words[W.bursts] = allocateBytes(maxBursts(capacity) * BURST_BYTES);
  words[W.colors] = allocateBytes(COLOR_BYTES);
  words[W.bornAt] = allocateBytes(capacity * 8);
  if (reports) words[W.endedAt] = allocateBytes(capacity * 48);
  for (const list of [W.ids, W.generation, W.free, W.older, W.newer, W.ramp, W.lifetime, W.sizeFactor]) {
    words[list] = allocateBytes(capacity * 4);
  }
  if (reports) words[W.endedIds] = allocateBytes(capacity * 4);
  const { Position } = world.previousAddresses;
  const { color, size } = world.addresses.Appearance;
  words[W.previousX] = Position.x;
  words[W.previousY] = Position.y;
  words[W.previousZ] = Position.z;
  words[W.color] = color;
  words[W.size] = size;
  words[W.generations] = world.internal.generations.byteOffset;
  words[W.capacity] = capacity;
  words[W.dimensions] = world.dimensions;
}

/** For each slot: its entity, the generation that the pool owns, the next older particle, and the times of its life, s. */
export interface PoolLists extends Readonly<Record<'ids' | 'generation' | 'older', Uint32Array>> {
  readonly bornAt: Float64Array;
  readonly lifetime: Float32Array;
}

export function poolOf({ buffer }: WebAssembly.Memory, words: Uint32Array, capacity: number): PoolLists {
  const list = (at: number) => new Uint32Array(buffer, words[at], capacity);
  return {
    ids: list(W.ids),
    generation: list(W.generation),
    older: list(W.older),
    bornAt: new Float64Array(buffer, words[W.bornAt], capacity),
    lifetime: new Float32Array(buffer, words[W.lifetime], capacity),
  };
}

/**
 * Creates the entities of a pool, ascending, all inactive.
 * @throws PhysicsError as `spawnMany`
 */
export function makeBodies(world: PhysicsWorld, options: EmitterOptions): Uint32Array {
  const { collider, linearDrag, quadraticDrag, charge, gravityScale, shape = 0, capacity, testParticle } = options;
  const ids = spawnMany(world, capacity, {
    position: {},
    velocity: {},
    mass: 1,
    appearance: { shape },
    collider,
    linearDrag,
    quadraticDrag,
    charge,
    gravityScale,
    testParticle: checkFlag(testParticle, 'testParticle') ? {} : undefined,
  });
  return ids.sort();
}

/**
 * Gives up the entities that lost a component which the emitter writes: other code may use their rows. Called when the
 * set of components of any entity has changed.
 */
export function dropIncomplete(world: PhysicsWorld, { words }: MemoryRecord): void {
  const { buffer } = world.memory;
  const waiting = new Uint32Array(buffer, waitingColumn(world).at, world.rows);
  const { members } = world.internal;
  const capacity = words[W.capacity];
  const ids = new Uint32Array(buffer, words[W.ids], capacity);
  const ownGenerations = new Uint32Array(buffer, words[W.generation], capacity);
  for (let slot = 0; slot < capacity; slot++) {
    if ((members[ids[slot]] & WRITTEN) === WRITTEN) continue;
    ownGenerations[slot] = NO_GENERATION;
    waiting[ids[slot]] = 0;
  }
}

/** Components that the creation of a particle writes. */
const WRITTEN = bitOf('Position') | bitOf('Velocity') | bitOf('Mass') | bitOf('Appearance');

/** Whether the pool owns the entity of a slot: it was not removed and has what the creation of a particle writes. */
export function ownsSlot({ internal }: PhysicsWorld, { ids, generation }: PoolLists, slot: number): boolean {
  const id = ids[slot];
  return internal.generations[id] === generation[slot] && (internal.members[id] & WRITTEN) === WRITTEN;
}

/** Removes the entities that the pool still owns. */
export function removeBodies(world: PhysicsWorld, { words }: MemoryRecord): void {
  const { buffer } = world.memory;
  const capacity = words[W.capacity];
  const ids = new Uint32Array(buffer, words[W.ids], capacity);
  const ownGenerations = new Uint32Array(buffer, words[W.generation], capacity);
  for (let slot = 0; slot < capacity; slot++) {
    if (world.internal.generations[ids[slot]] === ownGenerations[slot]) removeEntityCompletely(world, ids[slot]);
  }
}
