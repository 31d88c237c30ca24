// The memory and the entities of an emitter's pool.

import { spawnMany } from '../bodies/spawn-many.ts';
import { removeEntityCompletely } from '../ecs/bitecs-adapter.ts';
import { allocate } from '../memory/arena.ts';
import { resource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { EmitterOptions } from './options.ts';
import { type EmitterRecord, MAX_RAMPS, RECORD_BYTES, recordAt, W } from './record.ts';

/** Bursts that wait for the next step, and the bytes of one (kernels/emitters/record.ts). */
export const MAX_BURSTS = 256;
export const BURST_NUMBERS = 12;

/** 256 shades of each ramp. */
const COLOR_BYTES = MAX_RAMPS * 1024;
const SLOT_BYTES = 40;
const ENDING_BYTES = 52;

/** A piece of the world's memory for an emitter; it serves another when its own is destroyed. */
export interface Block {
  readonly record: EmitterRecord;
  readonly capacity: number;
  readonly reports: boolean;
}

/** Blocks whose emitters were destroyed: the world's memory is never given back. */
const idleBlocks = resource((): Block[] => []);

/** @throws PhysicsError E_CAPACITY */
export function takeBlock(world: PhysicsWorld, capacity: number, reports: boolean): Block {
  const idle = idleBlocks(world);
  const fits = (block: Block) =>
    block.capacity >= capacity && block.capacity <= 2 * capacity + 64 && block.reports === reports;
  const found = idle.findIndex(fits);
  if (found >= 0) return idle.splice(found, 1)[0];
  const { arena } = world.internal;
  const slots = capacity * (SLOT_BYTES + (reports ? ENDING_BYTES : 0));
  const bytes = RECORD_BYTES + MAX_BURSTS * BURST_NUMBERS * 8 + COLOR_BYTES + slots;
  return { record: recordAt(arena, allocate(arena, bytes + 64, `an emitter of ${capacity}`)), capacity, reports };
}

export function returnBlock(world: PhysicsWorld, block: Block): void {
  idleBlocks(world).push(block);
}

/** Lays out the block's arrays for `capacity` slots: those of 8 bytes a slot first. */
export function layOut(world: PhysicsWorld, { record, reports }: Block, capacity: number): void {
  const { words, numbers } = record;
  let top = record.at + RECORD_BYTES;
  const take = (bytes: number) => {
    top += bytes;
    return top - bytes;
  };
  words.fill(0);
  numbers.fill(0);
  words[W.bursts] = take(MAX_BURSTS * BURST_NUMBERS * 8);
  words[W.colors] = take(COLOR_BYTES);
  words[W.bornAt] = take(capacity * 8);
  if (reports) words[W.endedAt] = take(capacity * 48);
  for (const list of [W.ids, W.generation, W.free, W.older, W.newer, W.ramp, W.life, W.factor]) {
    words[list] = take(capacity * 4);
  }
  if (reports) words[W.endedIds] = take(capacity * 4);
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

/**
 * Makes the entities of a pool, ascending, all inert.
 * @throws PhysicsError as `spawnMany`
 */
export function makeBodies(world: PhysicsWorld, options: EmitterOptions): Uint32Array {
  const { collider, linearDrag, quadraticDrag, shape = 0, capacity } = options;
  const ids = spawnMany(world, capacity, {
    position: {},
    velocity: {},
    mass: 1,
    appearance: { shape },
    collider,
    linearDrag,
    quadraticDrag,
  });
  return ids.sort();
}

/** Removes those entities of a pool that are still its own. */
export function removeBodies(world: PhysicsWorld, { words }: EmitterRecord): void {
  const { buffer } = world.memory;
  const capacity = words[W.capacity];
  const ids = new Uint32Array(buffer, words[W.ids], capacity);
  const mine = new Uint32Array(buffer, words[W.generation], capacity);
  for (let slot = 0; slot < capacity; slot++) {
    if (world.internal.generations[ids[slot]] === mine[slot]) removeEntityCompletely(world, ids[slot]);
  }
}
