// Memory of forces: a force that is replaced gives it back, and the force that replaces it takes it.
import type { PhysicsWorld } from '../world/types.ts';
import { allocate } from './arena.ts';
import { namedResource, ResourceKey, stateAt } from './resource.ts';

export interface Block {
  readonly at: number;
  readonly bytes: number;
}

/** The key of the state of a force, which follows from the options of the force and the world. */
class ForceMemoryKey extends ResourceKey {}

/** Memory that forces gave back: the arena of a world frees none. */
const idleBlocks = namedResource('idle force memory', (): Block[] => []);

/** Returns the address of a block of this size, all zero. @throws PhysicsError E_CAPACITY */
export type TakeBytes = (bytes: number, what: string) => number;

/** State of a force, one per world. */
export interface ForceMemory<T> {
  /** Returns the state, created on first use. @throws PhysicsError E_CAPACITY */
  of(world: PhysicsWorld): T;
  /** Gives the memory back; the next use creates the state again. */
  release(world: PhysicsWorld): void;
  /** The key of the state among the resources of a world. */
  readonly key: object;
}

/** The state of a force as encoded snapshots carry it: addresses and numbers, and the blocks of memory that it owns. */
export interface CarriedState {
  readonly value: unknown;
  readonly blocks: readonly Block[];
}

/** As `resource`, for the state of a force that may be replaced, whose memory comes from `take`. */
export function forceMemory<T>(create: (world: PhysicsWorld, take: TakeBytes) => T): ForceMemory<T> {
  const key = new ForceMemoryKey(false);
  const make = (world: PhysicsWorld) => {
    const { top } = world.internal.arena;
    const blocks: Block[] = [];
    const take: TakeBytes = (bytes, what) => {
      const block = takeBlock(world, bytes, what);
      blocks.push(block);
      return block.at;
    };
    try {
      return { value: create(world, take), blocks };
    } catch (error) {
      // What came from the arena is free by itself.
      idleBlocks(world).push(...blocks.filter(({ at }) => at < top));
      throw error;
    }
  };
  return {
    of: (world) => stateAt(world, key, make).value,
    release(world) {
      if (!world.internal.resources.has(key)) return;
      idleBlocks(world).push(...stateAt(world, key, make).blocks);
      world.internal.resources.delete(key);
    },
    key,
  };
}

/** Returns the blocks of a resource that is the state of a force, undefined of any other. */
export function blocksOf(key: object, state: unknown): readonly Block[] | undefined {
  return key instanceof ForceMemoryKey ? (state as { readonly blocks: readonly Block[] }).blocks : undefined;
}

/** Gives blocks to the next forces that need some. */
export function addIdleBlocks(world: PhysicsWorld, blocks: readonly Block[]): void {
  if (blocks.length > 0) idleBlocks(world).push(...blocks);
}

function takeBlock(world: PhysicsWorld, bytes: number, what: string): Block {
  const idle = idleBlocks(world);
  const found = idle.findIndex((block) => block.bytes >= bytes && block.bytes <= 2 * bytes + 64);
  if (found < 0) return { at: allocate(world.internal.arena, bytes, what), bytes };
  const [block] = idle.splice(found, 1);
  new Uint8Array(world.memory.buffer, block.at, block.bytes).fill(0);
  return block;
}
