import { exp } from '@principia/physics';
import { expect, it } from 'vitest';
import { areaOf, graphOf, largestOf, leftSumOf, rootOf, slopeOf } from './functions.ts';

const cube = (x: number) => x * x * x - 2;

it('finds roots, slopes and points to rounding', () => {
  expect(rootOf(cube, 0, 2)).toBeCloseTo(Math.cbrt(2), 14);
  expect(slopeOf((x) => 3 * x * x - x, 2)).toBeCloseTo(11, 10);
  expect(graphOf(cube, 0, 2, 2)).toEqual([
    { x: 0, y: -2 },
    { x: 1, y: -1 },
    { x: 2, y: 6 },
  ]);
  expect(largestOf(cube, -1, 1)).toBe(3);
});

it('sums areas by both rules with their orders', () => {
  const exact = 1 - exp(-1);
  const decay = (x: number) => exp(-x);
  // The trapezoid rule errs by h²/12 times the change of the slope, the left rule by -h/2 times that of the value as well.
  const trapezoid = (1 - exp(-1)) / 120_000;
  expect(areaOf(decay, 0, 1, 100) - exact).toBeCloseTo(trapezoid, 8);
  expect(leftSumOf(decay, 0, 1, 100) - exact).toBeCloseTo((1 - exp(-1)) / 200 + trapezoid, 8);
});
