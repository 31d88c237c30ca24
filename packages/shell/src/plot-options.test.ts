import type uPlot from 'uplot';
import { expect, it } from 'vitest';
import { timeOptions } from './plot-options.ts';

it('leaves the numbers beside a plot the width of the widest', () => {
  const source = { unit: 'm', series: ['x'], read: () => {} };
  const { axes = [] } = timeOptions(source, ['#fff'], () => Number.NaN);
  const width = (...numbers: string[]) => {
    // Each character is seven pixels wide.
    const ctx = { save() {}, restore() {}, font: '', measureText: (text: string) => ({ width: 7 * text.length }) };
    const size = axes[1].size as (chart: uPlot, numbers: string[]) => number;
    return size({ ctx } as unknown as uPlot, numbers);
  };
  expect(width('0 m', '-200 mm')).toBeGreaterThanOrEqual(49);
  expect(width('0 m', '1 m')).toBe(46);
});

it('leaves half of the last number its room at the right, however long the game runs', () => {
  const source = { unit: 'm', series: ['x'], read: () => {} };
  const { padding = [] } = timeOptions(source, ['#fff'], () => Number.NaN);
  const room = (max: number) => {
    // Each character is seven pixels wide.
    const ctx = { save() {}, restore() {}, font: '', measureText: (text: string) => ({ width: 7 * text.length }) };
    return (padding[1] as (chart: uPlot) => number)({ ctx, scales: { x: { max } } } as unknown as uPlot);
  };
  // “100 s” is 35 pixels wide, “10000 s” 49.
  expect([room(1), room(100.02), room(10000)]).toEqual([12, 18, 25]);
});

it('shows the range of the values that there are, and zero', () => {
  const source = { unit: 'm', series: ['x'], read: () => {} };
  const { scales = {} } = timeOptions(source, ['#fff'], () => Number.NaN);
  const range = (...values: number[]) => {
    const data = [Float64Array.from(values, (_, i) => i), Float64Array.from(values)];
    return (scales.y.range as (chart: uPlot) => [number, number])({ data } as unknown as uPlot);
  };
  expect(range(Number.NaN, -2, 3)).toEqual([-2 * 1.08, 3 * 1.08]);
  expect(range(Number.NaN)).toEqual([0, 1]);
  expect(range(5)).toEqual([0, 5 * 1.08]);
});

it('begins with the time 0, and then shows the last seconds', () => {
  const source = { unit: 'm', series: ['x'], read: () => {} };
  const { scales = {} } = timeOptions(source, ['#fff'], () => Number.NaN);
  const range = scales.x.range as (chart: unknown, low: number, high: number) => [number, number];
  expect(range(undefined, 0, 0)).toEqual([0, 1]);
  expect(range(undefined, 0, 5)).toEqual([0, 5]);
  expect(range(undefined, 18, 30)).toEqual([18, 30]);
});
