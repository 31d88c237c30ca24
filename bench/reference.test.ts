import { expect, test } from 'vitest';
import { compareWithReference } from './reference.ts';

test('both go to every time in turns, and the distances at some of them are told', () => {
  const went: string[] = [];
  let now = 0;
  const result = compareWithReference({
    name: 'exact',
    times: [1, 2, 3],
    labels: new Map([[2, 'y2']]),
    ours: (time) => {
      went.push(`ours ${time}`);
      now = time;
    },
    theirs: (time) => {
      went.push(`theirs ${time}`);
    },
    apartKm: () => ({ earth: now, mars: 10 - now }),
  });
  expect(went).toEqual(['ours 1', 'theirs 1', 'ours 2', 'theirs 2', 'ours 3', 'theirs 3']);
  expect(result).toMatchObject({ name: 'exact', errorKm: { earth: { y2: 2 }, mars: { y2: 8 } }, worstKm: 9 });
  expect(Object.keys(result.errorKm.earth ?? {})).toEqual(['y2']);
  expect(result.timeRatio).toBeGreaterThan(0);
});
