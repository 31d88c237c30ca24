// Pairs of bodies whose centres are near each other: what forces between neighbours go through, such as those of molecules,
// of water made of particles, and of a flock.
//
// Bodies are sorted into cells a little wider than the distance, so that those near a body are in the 9 cells about it (27 in space).
// Cells are found by a hash of their coordinates, as there may be any number of them. Source: Teschner et al., Optimized
// Spatial Hashing for Collision Detection of Deformable Objects (2003).
import { assertUsable } from '../ecs/guards.ts';
import { bodies } from '../ecs/ranges.ts';
import { withoutWaiting } from '../emitters/waiting.ts';
import { checkNumber, mustBe } from '../errors/validate.ts';
import { namedResource } from '../memory/resource.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Pairs of bodies. The arrays belong to the world, and hold until it is asked again. */
export interface BodyPairs {
  readonly count: number;
  /** Entity ids of the pairs, `a[i]` < `b[i]`, in an order that is the same on every engine. */
  readonly a: Uint32Array;
  readonly b: Uint32Array;
}

interface Pairs {
  count: number;
  a: Uint32Array;
  b: Uint32Array;
}

/** Bodies, sorted so that those of a bucket follow each other, and those of the next cell along x do, too. */
interface Buckets {
  count: number;
  ids: Uint32Array;
  x: Float64Array;
  y: Float64Array;
  z: Float64Array;
  /** The row of cells of each body: its coordinates across x. */
  rowY: Float64Array;
  rowZ: Float64Array;
  /** The bucket of each body of the list, before they are sorted. */
  bucketOf: Uint32Array;
  /** Where each bucket starts, and the count of all; the number of buckets is a power of two. */
  starts: Uint32Array;
}

interface PairMemory {
  readonly buckets: Buckets;
  readonly pairs: Pairs;
}

const pairMemory = namedResource('pair memory', (): PairMemory => {
  return { buckets: bucketsFor(0), pairs: { count: 0, a: new Uint32Array(0), b: new Uint32Array(0) } };
});

function bucketsFor(capacity: number): Buckets {
  const reals = () => new Float64Array(capacity);
  let size = 16;
  while (size < 2 * capacity) size *= 2;
  return {
    count: 0,
    ids: new Uint32Array(capacity),
    x: reals(),
    y: reals(),
    z: reals(),
    rowY: reals(),
    rowZ: reals(),
    bucketOf: new Uint32Array(capacity),
    starts: new Uint32Array(size + 1),
  };
}

/**
 * Returns all pairs of bodies whose positions are at most a distance apart, in two dimensions or three. Takes 0.2 µs a body
 * where each is near seven others, and 0.4 µs in three dimensions. Of the entities of an emitter only living particles count.
 * @param distance m
 * @param among entity ids of bodies, ascending, of which the pairs are; default all bodies
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE, E_DESTROYED
 */
export function pairsWithin(world: PhysicsWorld, distance: number, among?: ArrayLike<number>): BodyPairs {
  assertUsable(world);
  checkNumber(distance, 'distance', { above: 0, max: 1e12 });
  const { ids, count } = withoutWaiting(world, checkIds(world, among));
  const memory = pairMemory(world);
  if (memory.buckets.ids.length < count) Object.assign(memory.buckets, bucketsFor(2 * count));
  const size = Math.max(distance * WIDER, farthest(world, ids, count) * LEAST_CELL);
  fillBuckets(world, memory.buckets, size, ids, count);
  memory.pairs.count = 0;
  findPairs(memory.buckets, memory.pairs, distance, size, world.dimensions === 3 ? 1 : 0);
  return memory.pairs;
}

/** @throws PhysicsError E_TYPE, E_RANGE unless the ids are those of bodies, ascending */
function checkIds(
  world: PhysicsWorld,
  among: ArrayLike<number> | undefined,
): { ids: ArrayLike<number>; count: number } {
  if (among === undefined) return bodies(world);
  const isList = typeof among === 'object' && among !== null && typeof among.length === 'number';
  if (!isList) throw mustBe('a list of entity ids', among, 'among');
  const { length } = among;
  const { members } = world.internal;
  for (let i = 0; i < length; i++) {
    const id = among[i];
    // Position is the first component: its bit is 1.
    if (!(Number.isInteger(id) && id > 0 && (members[id] & 1) !== 0))
      throw mustBe('a body', id, `among[${i}]`, 'E_RANGE');
    if (i > 0 && id <= among[i - 1]) throw mustBe('ascending', id, `among[${i}]`, 'E_RANGE');
  }
  return { ids: among, count: length };
}

/**
 * Cells are wider than the distance, and no smaller than this part of the greatest coordinate: then rounding, by 1.1e-16 of up to
 * 1e14 cells, does not put two bodies of a pair further apart than in neighbouring cells.
 */
const [WIDER, LEAST_CELL] = [1.03, 1e-14];

/** The greatest finite coordinate, m. */
function farthest({ components: { Position } }: PhysicsWorld, ids: ArrayLike<number>, count: number): number {
  let most = 0;
  for (const column of [Position.x, Position.y, Position.z]) {
    for (let i = 0; i < count; i++) {
      const size = Math.abs(column[ids[i]]);
      if (size > most && size < Infinity) most = size;
    }
  }
  return most;
}

/** A number for each row of cells along x. Large coordinates wrap. */
function hashOfRow(y: number, z: number): number {
  return Math.imul(y | 0, 19349663) ^ Math.imul(z | 0, 83492791);
}

/** Sorts bodies by their buckets, by counting how many are in each. */
function fillBuckets(world: PhysicsWorld, buckets: Buckets, size: number, ids: ArrayLike<number>, count: number): void {
  const { x, y, z, rowY, rowZ, bucketOf, starts } = buckets;
  const { Position } = world.components;
  const isSolid = world.dimensions === 3;
  const mask = starts.length - 2;
  buckets.count = count;
  starts.fill(0);
  for (let i = 0; i < count; i++) {
    const id = ids[i];
    const row = hashOfRow(Math.floor(Position.y[id] / size), isSolid ? Math.floor(Position.z[id] / size) : 0);
    bucketOf[i] = (row + (Math.floor(Position.x[id] / size) | 0)) & mask;
    starts[bucketOf[i]]++;
  }
  for (let h = 1; h <= mask + 1; h++) starts[h] += starts[h - 1];
  // So far these are the ends; from the last body to the first, they become the starts.
  for (let i = count - 1; i >= 0; i--) {
    const id = ids[i];
    const k = --starts[bucketOf[i]];
    buckets.ids[k] = id;
    x[k] = Position.x[id];
    y[k] = Position.y[id];
    z[k] = isSolid ? Position.z[id] : 0;
    rowY[k] = Math.floor(y[k] / size);
    rowZ[k] = Math.floor(z[k] / size);
  }
}

/** Finds the pairs of each body with those behind it in the three rows of cells about it, or nine in space. */
function findPairs(buckets: Buckets, pairs: Pairs, distance: number, size: number, layers: number): void {
  const { count, x, rowY, rowZ, starts } = buckets;
  const mask = starts.length - 2;
  for (let k = 0; k < count; k++) {
    const column = Math.floor(x[k] / size) | 0;
    // Counted by small numbers, because adding 1 does not change a number that is not finite.
    for (let n = -layers; n <= layers; n++) {
      for (let m = -1; m <= 1; m++) {
        const ry = rowY[k] + m;
        const rz = rowZ[k] + n;
        // The cells before, at, and after the body are in three buckets that follow each other, but for the last and the first.
        const first = (hashOfRow(ry, rz) + column - 1) & mask;
        if (first + 2 <= mask) findInRow(buckets, pairs, k, ry, rz, starts[first], starts[first + 3], distance);
        else {
          for (const bucket of [first, (first + 1) & mask, (first + 2) & mask]) {
            findInRow(buckets, pairs, k, ry, rz, starts[bucket], starts[bucket + 1], distance);
          }
        }
      }
    }
  }
}

/** Appends the pairs of body `k` with those of a row among the bodies from `start` to `end` that follow it and are near. */
function findInRow(
  { ids, x, y, z, rowY, rowZ }: Buckets,
  pairs: Pairs,
  k: number,
  ry: number,
  rz: number,
  start: number,
  end: number,
  distance: number,
): void {
  for (let m = Math.max(start, k + 1); m < end; m++) {
    const dx = x[m] - x[k];
    const dy = y[m] - y[k];
    const dz = z[m] - z[k];
    // Other rows may have the same buckets.
    if (!(dx * dx + dy * dy + dz * dz <= distance * distance) || rowY[m] !== ry || rowZ[m] !== rz) continue;
    if (pairs.count === pairs.a.length) growPairs(pairs);
    pairs.a[pairs.count] = Math.min(ids[k], ids[m]);
    pairs.b[pairs.count++] = Math.max(ids[k], ids[m]);
  }
}

function growPairs(pairs: Pairs): void {
  for (const key of ['a', 'b'] as const) {
    const longer = new Uint32Array(Math.max(256, 2 * pairs[key].length));
    longer.set(pairs[key]);
    pairs[key] = longer;
  }
}
