import { expect, it } from 'vitest';
import { SeriesHistory } from './series-history.ts';
import { siNumber } from './si-number.ts';

const at = (time: number) => [time, 2 * time, 3 * time];

it('keeps the last rows in the same memory', () => {
  const history = new SeriesHistory(3, 4);
  for (const time of [0, 1, 2]) history.add(time, time, at(time));
  expect(history.data().map((column) => [...column])).toEqual([
    [0, 1, 2],
    [0, 1, 2],
    [0, 2, 4],
    [0, 3, 6],
  ]);
  const { buffer } = history.data()[0];
  for (let time = 3; time < 1000; time++) {
    history.add(time, time, at(time));
    expect([...history.data()[3]]).toEqual([3, 2, 1, 0].filter((ago) => ago <= time).map((ago) => 3 * (time - ago)));
  }
  expect(history.data()[0].buffer).toBe(buffer);
  history.clear();
  expect(history.count).toBe(0);
});

it('forgets the future when somebody went back', () => {
  const history = new SeriesHistory(1, 8);
  for (const tick of [0, 1, 2, 3]) history.add(tick, 0.1 * tick, [tick]);
  expect(history.lastBefore(0.15)).toBe(1);
  expect(history.discardFrom(2)).toBe(true);
  expect(history.discardFrom(2)).toBe(false);
  expect([...history.data()[1]]).toEqual([0, 1]);
  expect(history.lastBefore(0.35)).toBe(1);
});

it('thins out what it has to evenly spaced rows', () => {
  const history = new SeriesHistory(1, 5);
  for (let tick = 0; tick < 9; tick++) history.add(tick, tick / 10, [tick]);
  history.thin(2, 4);
  expect([...history.data()[1]]).toEqual([4, 6, 8]);
  for (const tick of [10, 12]) history.add(tick, tick / 10, [tick]);
  expect([...history.data()[1]]).toEqual([6, 8, 10, 12]);
});

it('writes numbers short', () => {
  const joules = [0, 0.0123, 5, 1234, 56_789_000, -2e-9, 1000, 3e15].map((value) => siNumber(value, 'J'));
  expect(joules).toEqual(['0 J', '12.3 mJ', '5 J', '1.23 kJ', '56.8 MJ', '-2 nJ', '1 kJ', '3000 TJ']);
  expect([0, 1234, 2e6, 1e-5].map((value) => siNumber(value, 'kg m/s'))).toEqual([
    '0 kg m/s',
    '1230 kg m/s',
    '2.0e6 kg m/s',
    '1.0e-5 kg m/s',
  ]);
  expect(siNumber(0.5, '')).toBe('0.5');
});
