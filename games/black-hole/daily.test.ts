import { dayOf } from '@principia/shell';
import { expect, it } from 'vitest';
import { dayOfSeed, seedOf } from './daily.ts';
import { play } from './game-lab.ts';
import { outcomeOf } from './report.ts';

it('every date has a seed, and the seed its date', () => {
  for (const day of ['2026-11-23', '2028-02-29', '2031-01-01']) {
    expect(dayOf(new Date(`${day}T23:59:00`))).toBe(day);
    expect(dayOfSeed(seedOf(day))).toBe(day);
  }
  for (const seed of [1, 20_261_301, 20_260_230, 19_991_231, 4_294_967_295]) expect(dayOfSeed(seed)).toBeUndefined();
});

it('a result tells the day and the slingshots, and a game that began at a higher level is not ranked', () => {
  const game = play(20_261_123);
  Object.assign(game.rules, { phase: 'over', dodged: 3, score: 6, bonus: 2, slingshots: 3 });
  expect(outcomeOf(game)).toMatchObject({
    score: 8,
    share: 'Black hole, daily 2026-11-23: level 4, 3 slingshots, 6 points + 2 bonus',
  });
  const high = play(5, { level: 4 });
  expect(high.rules).toMatchObject({ level: 4, dodged: 3, goalPoints: 4 });
  expect(high.scene.holes).toHaveLength(4);
  Object.assign(high.rules, { phase: 'over', dodged: 4, score: 4 });
  expect(outcomeOf(high)).toMatchObject({
    score: 0,
    lines: ['1 level cleared, 0 slingshots', '4 points + 0 bonus', expect.stringMatching(/^Not ranked/)],
  });
});
