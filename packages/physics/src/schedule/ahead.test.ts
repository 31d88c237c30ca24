import { expect, test } from 'vitest';
import { spawnMany } from '../bodies/spawn-many';
import { linearDrag } from '../forces/drag';
import type { Spans } from '../store/spans';
import { createPhysicsWorld } from '../world';
import { aheadOf, lookAhead, lookNowhere } from './ahead';

const world = createPhysicsWorld({ capacity: 10_000, precision: 'f32', forces: [linearDrag()] });
spawnMany(world, 10, { position: {}, velocity: {}, mass: 1 });

/** What lies ahead of the tile [first, last) of run r: bytes to it, and how many columns are read. */
function after(bounds: number[], r: number, first: number, last: number): [number, number] {
  const ahead = aheadOf(world);
  const spans = { bounds: Int32Array.from(bounds), count: bounds.length / 2 } as unknown as Spans;
  world.internal.tile.bounds.set([first, last]);
  lookAhead(world, ahead, spans, r);
  return [ahead[0], ahead[1]];
}

test('the columns that lie ahead are those that a tile reads, each once', () => {
  const [, , ...columns] = aheadOf(world);
  const { Position, Velocity, Mass, LinearDrag } = world.addresses;
  const drag = Object.values(LinearDrag);
  expect(columns).toEqual(expect.arrayContaining([Position.x, Velocity.y, Mass.value, ...drag]));
  expect(new Set(columns).size).toBe(columns.length);
});

test('the next tile is the one behind, or the first of the next run, and none where it would be shorter', () => {
  const all = aheadOf(world).length - 2;
  expect(after([0, 4096], 0, 0, 2048)).toEqual([4 * 2048, all]);
  expect(after([0, 2048, 6144, 8192], 0, 0, 2048)).toEqual([4 * 6144, all]);
  expect(after([0, 4000], 0, 0, 2048)[1]).toBe(0);
  expect(after([0, 2048], 0, 0, 2048)[1]).toBe(0);
});

test('nothing lies ahead when told so', () => {
  const ahead = aheadOf(world);
  ahead[1] = 5;
  lookNowhere(ahead);
  expect(ahead[1]).toBe(0);
});
