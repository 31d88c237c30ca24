import { expect, test } from 'vitest';
import { histogram, median, summarise } from './statistics.ts';

test('least, median and 99th percentile', () => {
  const series = Array.from({ length: 101 }, (_, i) => 100 - i);
  expect(summarise(series)).toEqual({ min: 0, median: 50, p99: 99 });
  expect(median([4, 1, 3, 2])).toBe(2.5);
  expect(summarise([7])).toEqual({ min: 7, median: 7, p99: 7 });
});

test('an empty series has no summary', () => {
  expect(summarise([])).toEqual({ min: Number.NaN, median: Number.NaN, p99: Number.NaN });
});

test('numbers are ordered as numbers', () => {
  expect(median([10, 9, 100])).toBe(10);
});

test('a histogram counts everything, outliers in the last bin', () => {
  const series = [...Array.from({ length: 1000 }, (_, i) => i), 1e6];
  const { from, counts } = histogram(series, 10);
  expect(from).toBe(0);
  expect(counts.reduce((a, b) => a + b)).toBe(1001);
  expect(counts[9]).toBeGreaterThan(100);
  expect(histogram([5, 5, 5], 4).counts).toEqual([3, 0, 0, 0]);
});
