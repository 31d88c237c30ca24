/** What the shell and the tests learn about a game. */
import type { Outcome } from '@principia/shell';
import type { SubmarineGame } from './sim.ts';
import { WORDS } from './words.ts';

export function outcomeOf(game: SubmarineGame): Outcome | undefined {
  const { boat, level, taken } = game;
  if (boat.ending === 'none') return undefined;
  const score = game.score();
  const lines = [WORDS.result(level, boat.collected, taken.length), WORDS.points(score)];
  return { title: WORDS.endings[boat.ending], score, lines, share: WORDS.share(level, score) };
}

/** The state that tests read. */
export function reportState(game: SubmarineGame) {
  const { boat, depth, ratio, level } = game;
  return { ...boat, depth, ratio, level, crates: game.taken.length, score: game.score() };
}
