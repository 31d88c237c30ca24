import { expect, it } from 'vitest';
import { EnergyHistory } from './energy-history.ts';
import { joules } from './joules.ts';

const at = (time: number) => ({ kinetic: time, potential: 2 * time, total: 3 * time });

it('keeps the last samples in the same memory', () => {
  const history = new EnergyHistory(4, 0.1);
  for (const time of [0, 1, 2]) history.add(time, at(time));
  expect(history.data().map((column) => [...column])).toEqual([
    [0, 1, 2],
    [0, 1, 2],
    [0, 2, 4],
    [0, 3, 6],
  ]);
  const { buffer } = history.data()[0];
  for (let time = 3; time < 1000; time++) history.add(time, at(time));
  expect([...history.data()[3]]).toEqual([996, 997, 998, 999].map((time) => 3 * time));
  expect(history.data()[0].buffer).toBe(buffer);
  history.clear();
  expect(history.count).toBe(0);
});

it('asks for a sample at most once an interval', () => {
  const history = new EnergyHistory(4, 0.05);
  expect(history.isDue(0)).toBe(true);
  history.add(0, at(0));
  expect([1 / 60, 2 / 60, 3 / 60].map((time) => history.isDue(time))).toEqual([false, false, true]);
});

it('writes energies short', () => {
  expect([0, 0.0123, 5, 1234, 56_789_000].map(joules)).toEqual(['0 J', '12.3 mJ', '5 J', '1.23 kJ', '56.8 MJ']);
});
