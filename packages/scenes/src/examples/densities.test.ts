import { createRandom, exp } from '@principia/physics';
import { expect, test } from 'vitest';
import { densities } from './densities.ts';

test('each number counts in its interval, and numbers beyond the range only as part of the whole', () => {
  // Four of eight numbers are in range: width 0.5, so one number is 1/(8 · 0.5) = 0.25.
  expect([...densities([0, 0.49, 0.5, 0.99, 1, -0.01, 7, Number.NaN], 0, 1, 2)]).toEqual([0.5, 0.5]);
  expect([...densities([], 0, 1, 3)]).toEqual([0, 0, 0]);
});

test('a normal distribution has its density', () => {
  const random = createRandom(1);
  const count = 100_000;
  const samples = Float64Array.from({ length: count }, () => random.gaussian());
  const found = densities(samples, -3, 3, 30);
  const width = 0.2;
  found.forEach((density, i) => {
    const x = -3 + width * (i + 0.5);
    const exact = exp((-x * x) / 2) / Math.sqrt(2 * Math.PI);
    // Five standard errors of a Poisson count, and f″ w²/24 for the mean over an interval.
    const tolerance = 5 * Math.sqrt(exact / (count * width)) + (0.4 * width * width) / 24;
    expect(Math.abs(density - exact)).toBeLessThan(tolerance);
  });
});
