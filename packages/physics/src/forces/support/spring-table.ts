// The record that the spring kernels read: the addresses of the columns, and the list of springs, kept until springs
// change.
import { bitOf } from '../../components/membership.ts';
import { removeEntityCompletely } from '../../ecs/bitecs/remove-entity.ts';
import { type EntityList, emptyEntityList, refreshEntityList } from '../../ecs/entity-list.ts';
import { collectThrown } from '../../errors/collect-thrown.ts';
import { SPRING_TABLE_BYTES, SpringTableNumber, SpringTableWord as Word } from '../../memory/layouts.gen.ts';
import { allocateRecord } from '../../memory/record.ts';
import { namedResource } from '../../memory/resource.ts';
import type { PhysicsWorld } from '../../world/types.ts';

export interface SpringTable {
  readonly at: number;
  readonly entityList: EntityList;
  readonly words: Uint32Array;
  /** Largest stiffness over reduced mass, 1/s², and damping over reduced mass, 1/s. */
  readonly maxima: Float64Array;
  /** The values of `maxima` and the step, s, with which the integrator `passedBy` was last stable. */
  readonly passed: Float64Array;
  passedBy: object | undefined;
  /** The springs removed because they lost an end, ascending, and the step before which they were: `world.tick` of then. */
  removed: number[];
  removedIn: number;
}

export const springTable = namedResource('spring table', (world): SpringTable => {
  const { at, words, numbers } = allocateRecord(world.internal.arena, SPRING_TABLE_BYTES, 'springs');
  const { a, b, aGeneration, bGeneration, stiffness, damping, length, tensionOnly } = world.addresses.Spring;
  words.set([a, b, aGeneration, bGeneration, stiffness, damping, length, tensionOnly], Word.a);
  words[Word.generations] = world.internal.generations.byteOffset;
  words[Word.rows] = world.rows;
  const maxima = numbers.subarray(SpringTableNumber.maxStiffness, SpringTableNumber.maxDamping + 1);
  world.internal.springTable = addressOf;
  const passed = new Float64Array(3).fill(Number.NaN);
  return { at, words, maxima, passed, passedBy: undefined, removed: [], removedIn: -1, entityList: emptyEntityList() };
});

/** A snapshot may drop the record: it is then made anew. */
const addressOf = (world: PhysicsWorld) => springTable(world).at;

/**
 * Lists the springs whose ends both live, and the largest stiffness: ends and stiffness may have been changed in
 * place.
 */
export function scanSprings(world: PhysicsWorld): SpringTable {
  const table = springTable(world);
  const { entityList, words } = table;
  // Behind the ids: 12 bytes per active spring, 4 per spring that lost an end.
  if (refreshEntityList(world, entityList, 'Spring', 16)) {
    words[Word.ids] = entityList.ids;
    words[Word.links] = entityList.at;
    words[Word.dangling] = entityList.at + entityList.capacity * 12;
    words[Word.count] = entityList.count;
  }
  world.kernels.scanSprings(table.at, bitOf('Position'));
  return table;
}

/** Removes the springs that lost an end, with their entities. */
export function removeDanglingSprings(world: PhysicsWorld, table: SpringTable): void {
  const count = table.words[Word.danglingCount];
  if (count === 0) return;
  const ids = Array.from(new Uint32Array(world.memory.buffer, table.words[Word.dangling], count));
  // Nobody has heard of those that were removed before a step that was refused.
  const unheard = table.removedIn === world.tick ? table.removed : [];
  table.removed = [...unheard, ...ids].sort((a, b) => a - b);
  table.removedIn = world.tick;
  for (const spring of ids) {
    try {
      removeEntityCompletely(world, spring);
    } catch (error) {
      collectThrown(world, error);
    }
  }
}

/** Returns the active springs as triples: id of the spring, body a, body b. */
export function activeSprings(world: PhysicsWorld, { words }: SpringTable): Uint32Array {
  return new Uint32Array(world.memory.buffer, words[Word.links], 3 * words[Word.active]);
}
