import { expect, test } from 'vitest';
import { countsBetween, growthOf } from './scaling.ts';
import { scalingChart } from './scaling-chart.ts';

test('counts go from the first to the last, two a decade', () => {
  expect(countsBetween(1e4, 1e6)).toEqual([10_000, 32_000, 100_000, 320_000, 1_000_000]);
  expect(countsBetween(100, 200)).toEqual([100, 200]);
});

test('the growth is the power of what was measured', () => {
  const points = [10, 100, 1000].map((count) => ({ count, msPerStep: 3 * count ** 1.7 }));
  expect(growthOf(points)).toBeCloseTo(1.7, 12);
});

test('the chart names its lines and its decades', () => {
  const points = [1e4, 1e5, 1e6].map((count) => ({ count, msPerStep: count * Math.log2(count) * 1e-4 }));
  const svg = scalingChart([{ name: 'tree', points }]);
  for (const text of ['tree', '10,000', '1,000,000', 'N log N', '100 ms']) expect(svg).toContain(text);
});
