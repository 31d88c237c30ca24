import { expect, test } from 'vitest';
import { compareWithReference } from './reference';

test('both go to every time in turns, twice, and the second pass is told', () => {
  const went: string[] = [];
  let made = 0;
  const result = compareWithReference(() => {
    made++;
    let now = 0;
    return {
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
      apartKm: () => ({ earth: now, mars: 10 * made - now }),
    };
  });
  expect(went).toEqual([...went.slice(0, 6), ...went.slice(0, 6)]);
  expect(went.slice(0, 4)).toEqual(['ours 1', 'theirs 1', 'ours 2', 'theirs 2']);
  expect(result).toMatchObject({ name: 'exact', errorKm: { earth: { y2: 2 }, mars: { y2: 18 } }, worstKm: 19 });
  expect(Object.keys(result.errorKm.earth ?? {})).toEqual(['y2']);
  expect(result.timeRatio).toBeGreaterThan(0);
});
