import { expect, it } from 'vitest';
import { Sampling } from './sampling.ts';

it('has a row for each step of the last twelve seconds, or as many as there is room for', () => {
  const dts = [1 / 60, 1 / 240, 1 / 1000, 1 / 2000, 1e-4, 1, 86_400];
  expect(dts.map((dt) => new Sampling(dt, 'time')).map(({ stride, rows }) => [stride, rows])).toEqual([
    [1, 720],
    [1, 2880],
    [1, 12_000],
    [1, 24_000],
    [5, 24_000],
    [1, 240],
    [1, 240],
  ]);
  expect(new Sampling(1 / 1000, 'path')).toMatchObject({ stride: 2, rows: 20_000 });
});

it('has the rows that a game asks for, rounded to whole steps, whatever they cost', () => {
  const sampling = new Sampling(0.01, 'time', 0.1);
  expect(sampling).toMatchObject({ stride: 10, rows: 240 });
  for (let i = 0; i < 1000; i++) expect(sampling.spent(100)).toBe(false);
  expect(new Sampling(0.01, 'time', 1e-9)).toMatchObject({ stride: 1, rows: 1200 });
  for (const wrong of [0, -1, Number.NaN, Infinity]) {
    expect(() => new Sampling(0.01, 'time', wrong)).toThrow(`plotInterval of a game must be a time above zero, s, got`);
  }
});

it('reads less often what takes more than a twentieth of the time, at least once in 0.05 s', () => {
  const after = (dt: number, costs: readonly number[]) => {
    const sampling = new Sampling(dt, 'time');
    const rose = costs.filter((cost) => sampling.spent(cost)).length;
    return [sampling.stride, rose];
  };
  const always = (cost: number) => Array.from({ length: 1000 }, () => cost);
  // A step of 1 ms leaves 0.05 ms: 0.12 ms are due every third step.
  expect(after(0.001, always(0.049))).toEqual([1, 0]);
  expect(after(0.001, always(0.12))).toEqual([3, 1]);
  expect(after(0.001, always(1000))).toEqual([50, 1]);
  expect(after(0.1, always(1000))).toEqual([1, 0]);
  // Twice an interruption of the machine.
  expect(after(0.001, [400, 400, ...always(0.01)])).toEqual([1, 0]);
});
