import { expect, it } from 'vitest';
import { HighScores } from './high-scores.ts';
import type { LocalStore } from './local-store.ts';

function memory(text?: string): LocalStore {
  let kept = text;
  return {
    getItem: () => kept ?? null,
    setItem(_, value) {
      kept = value;
    },
  };
}

it('keeps the best five, best first', () => {
  const storage = memory();
  const scores = new HighScores('stones', storage);
  expect(scores.best).toBe(0);
  expect([3, 9, 1, 0, 4, 7].map((score) => scores.add(score, '2001-12-31'))).toEqual([0, 0, 2, -1, 1, 1]);
  expect(scores.add(1, '2002-01-01')).toBe(-1);
  const again = new HighScores('stones', storage);
  expect(again.list.map(({ score }) => score)).toEqual([9, 7, 4, 3, 1]);
  expect(again.best).toBe(9);
});

it('keeps what another tab has added since', () => {
  const storage = memory();
  const [one, other] = [new HighScores('stones', storage), new HighScores('stones', storage)];
  one.add(100, '2001-12-31');
  expect(other.add(5, '2001-12-31')).toBe(1);
  expect(new HighScores('stones', storage).list.map(({ score }) => score)).toEqual([100, 5]);
});

it.each(['', 'nonsense', '{}', '[1, null, {"score":"x","day":"y"}]'])('takes %j for an empty list', (text) => {
  expect(new HighScores('stones', memory(text)).list).toEqual([]);
});

it('lasts as long as the page where nothing is kept', () => {
  const closed: LocalStore = {
    getItem: () => {
      throw new Error('closed');
    },
    setItem: () => {
      throw new Error('closed');
    },
  };
  const scores = new HighScores('stones', closed);
  expect(scores.add(5, '2001-12-31')).toBe(0);
  expect(scores.best).toBe(5);
});
