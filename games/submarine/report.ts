/** What the shell and the tests learn about a game. */
import type { Outcome } from '@principia/shell';
import type { SubmarineGame } from './sim.ts';
import { ENDINGS } from './words.ts';

export function outcomeOf(game: SubmarineGame): Outcome | undefined {
  const { boat, level, taken } = game;
  if (boat.ending === 'none') return undefined;
  const score = game.score();
  const lines = [`Level ${level}: ${boat.collected} of ${taken.length} crates`, `${score} points`];
  return { title: ENDINGS[boat.ending], score, lines, share: `Submarine, level ${level}: ${score} points` };
}

/** The state that tests read. */
export function reportState(game: SubmarineGame) {
  const { boat, depth, ratio, level } = game;
  return { ...boat, depth, ratio, level, crates: game.taken.length, score: game.score() };
}
