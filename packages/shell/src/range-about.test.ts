import { expect, it } from 'vitest';
import { rangeAbout } from './range-about.ts';

it('shows all values, with a margin', () => {
  const [low, high] = rangeAbout(0, 100);
  expect(low).toBeCloseTo(-6, 12);
  expect(high).toBeCloseTo(106, 12);
});

it('is wide enough for labels where rounding alone makes the values differ', () => {
  for (const value of [1, -3e8, 1e-30]) {
    const [low, high] = rangeAbout(value, value + Math.abs(value) * 2 ** -50);
    expect(low).toBeLessThan(value);
    expect((high - low) / Math.abs(value)).toBeGreaterThan(1e-6);
  }
  expect(rangeAbout(0, 0)).toEqual([-1, 1]);
});

it('is that of a unit while there is no value', () => {
  expect(rangeAbout(null, null)).toEqual([-1, 1]);
  expect(rangeAbout(Infinity, -Infinity)).toEqual([-1, 1]);
  expect(rangeAbout(Number.NaN, Number.NaN)).toEqual([-1, 1]);
});
