import { createRandom } from '@principia/physics';
import { expect, test } from 'vitest';
import { blackHole } from './black-hole.ts';
import { findCorridor, isClear } from './black-hole-corridor.ts';
import { BLACK_HOLE, drawHoles, holeMu } from './black-hole-layout.ts';
import type { Hole } from './black-hole-types.ts';

const resting = { orbit: 0, rate: 0, phase: 0 };

test.each([false, true])(
  'every layout of a thousand seeds has a corridor that keeps clear of all holes; steep: %s',
  (isSteep) => {
    for (let seed = 1; seed <= 1000; seed++) {
      const count = 1 + (seed % 12);
      const holes = drawHoles(createRandom(seed, 1), count, seed % 2 === 0 ? Math.ceil(count / 3) : 0, isSteep);
      const way = findCorridor(holes, BLACK_HOLE, isSteep);
      if (way === undefined) throw new Error(`no corridor for seed ${seed}`);
      const isJoined = Math.abs(way[0] - 400) <= 10 && Math.abs(way[1] - 50) <= 10 && way[way.length - 1] > 550;
      let blocked = 0;
      for (let i = 0; i < way.length; i += 2) if (!isClear(holes, way[i], way[i + 1])) blocked++;
      const strays = holes.filter(
        ({ x, y, radius }) => x < 0 || x >= 800 || y < 200 || y >= 550 || radius < 10 || radius >= 30,
      );
      expect([seed, isJoined, blocked, strays]).toEqual([seed, true, 0, []]);
    }
  },
  60_000,
);

test('finds no corridor through a wall of holes, nor up a hill too high', () => {
  const wall: Hole[] = Array.from({ length: 21 }, (_, i) => ({ x: 40 * i, y: 400, radius: 22, ...resting }));
  expect(findCorridor(wall, BLACK_HOLE)).toBeUndefined();
  expect(findCorridor(wall.slice(0, 19), BLACK_HOLE)).toBeDefined();
  // From deep in the well of a giant below, 10 m/s² do not lead out.
  const giant = [{ x: 400, y: -300, radius: 250, ...resting }];
  expect(findCorridor(giant, BLACK_HOLE)).toBeUndefined();
});

test('even the largest crowd leaves a corridor', () => {
  for (let seed = 1; seed <= 5; seed++) {
    const holes = drawHoles(createRandom(seed, 1), BLACK_HOLE.most, 13);
    expect(findCorridor(holes, BLACK_HOLE)).toBeDefined();
  }
});

test('first holes lie all over their zone', () => {
  const places = Array.from({ length: 100 }, (_, seed) => blackHole.create({ seed }).holes[0]);
  const left = places.filter(({ x }) => x < 400).length;
  const low = places.filter(({ y }) => y < 375).length;
  expect(Math.abs(left - 50)).toBeLessThan(20);
  expect(Math.abs(low - 50)).toBeLessThan(20);
});

test('the disc is the horizon', () => {
  for (const radius of [10, 17.3, 30]) expect(Math.sqrt((2 * holeMu(radius)) / radius)).toBeCloseTo(200, 12);
});
