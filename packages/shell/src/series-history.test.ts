import { expect, it } from 'vitest';
import { SeriesHistory } from './series-history.ts';
import { siNumber } from './si-number.ts';

const at = (time: number) => [time, 2 * time, 3 * time];

it('keeps the last samples in the same memory', () => {
  const history = new SeriesHistory(3, 4, 0.1);
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
  const history = new SeriesHistory(3, 4, 0.05);
  expect(history.isDue(0)).toBe(true);
  history.add(0, at(0));
  expect([1 / 60, 2 / 60, 3 / 60].map((time) => history.isDue(time))).toEqual([false, false, true]);
});

it('forgets the future when somebody went back', () => {
  const history = new SeriesHistory(1, 8, 0.1);
  for (const time of [0, 1, 2, 3]) history.add(time, [time]);
  expect(history.discardAfter(1.5)).toBe(true);
  expect(history.discardAfter(1.5)).toBe(false);
  expect([...history.data()[1]]).toEqual([0, 1]);
  expect(history.isDue(1.6)).toBe(true);
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
