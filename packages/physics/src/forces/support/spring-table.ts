// The record that the spring kernels read: the addresses of the columns, and the list of springs, kept until springs
// change.
import { bitOf } from '../../components/all.ts';
import { removeWholly } from '../../ecs/bitecs-adapter.ts';
import { type EntityList, emptyEntityList, refreshEntityList } from '../../ecs/entity-list.ts';
import { collectThrown } from '../../errors/collect-thrown.ts';
import { allocate } from '../../memory/arena.ts';
import { resource } from '../../memory/resource.ts';
import type { PhysicsWorld } from '../../world/types.ts';

/** The number of words before the two f64, in the order of the class in kernels/forces/springs.ts. */
const WORDS = 16;
const TABLE_BYTES = WORDS * 4 + 16;
const [IDS, LINKS, LOST, COUNT, ACTIVE, LOST_COUNT] = [9, 10, 11, 12, 13, 14];

export interface SpringTable {
  readonly at: number;
  readonly entityList: EntityList;
  readonly words: Uint32Array;
  /** Largest stiffness over reduced mass, 1/s², and damping over reduced mass, 1/s. */
  readonly stiffest: Float64Array;
  /** The values of `stiffest` and the step, s, with which the integrator `passedBy` was last stable. */
  readonly passed: Float64Array;
  passedBy: object | undefined;
  /** The springs removed before the last step because they lost an end. */
  removed: number[];
}

export const springTable = resource((world): SpringTable => {
  const { arena } = world.internal;
  const at = allocate(arena, TABLE_BYTES, 'springs');
  const words = new Uint32Array(arena.memory.buffer, at, WORDS);
  const { a, b, aLife, bLife, stiffness, damping, length, tensionOnly } = world.addresses.Spring;
  const generations = world.internal.generations.byteOffset;
  words.set([a, b, aLife, bLife, stiffness, damping, length, tensionOnly, generations, 0, 0, 0, 0, 0, 0, world.rows]);
  const stiffest = new Float64Array(arena.memory.buffer, at + WORDS * 4, 2);
  const passed = new Float64Array(3).fill(Number.NaN);
  return { at, words, stiffest, passed, passedBy: undefined, removed: [], entityList: emptyEntityList() };
});

/**
 * Lists the springs whose ends both live, and the largest stiffness: ends and stiffness may have been changed in
 * place.
 */
export function scanSprings(world: PhysicsWorld): SpringTable {
  const table = springTable(world);
  const { entityList, words } = table;
  // Behind the ids: 12 bytes per active spring, 4 per spring that lost an end.
  if (refreshEntityList(world, entityList, 'Spring', 16)) {
    words.set([entityList.ids, entityList.at, entityList.at + entityList.room * 12], IDS);
    words[COUNT] = entityList.count;
  }
  world.kernels.scanSprings(table.at, bitOf('Position'));
  return table;
}

/** Removes the springs that lost an end, with their entities. */
export function removeLost(world: PhysicsWorld, table: SpringTable): void {
  const lost = table.words[LOST_COUNT];
  if (lost === 0 && table.removed.length === 0) return;
  const ids = new Uint32Array(world.memory.buffer, table.words[LOST], lost);
  table.removed = Array.from(ids);
  for (const spring of table.removed) {
    try {
      removeWholly(world, spring);
    } catch (error) {
      collectThrown(world, error);
    }
  }
}

/** Returns the active springs as triples: id of the spring, body a, body b. */
export function activeSprings(world: PhysicsWorld, { words }: SpringTable): Uint32Array {
  return new Uint32Array(world.memory.buffer, words[LINKS], 3 * words[ACTIVE]);
}
