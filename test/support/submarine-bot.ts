/** What wins a level of the submarine, found without a page. */
import { createGame } from '../../games/submarine/sim.ts';
import { sailHome } from '../../games/submarine/test-pilot.ts';

/** What is held, to the right and up, −1, 0 or 1, and for how many steps. */
export interface Move {
  readonly x: number;
  readonly y: number;
  readonly steps: number;
}

/** What brings up all crates of a level. */
export function winningMoves(level: number, seed: number): Move[] {
  const game = createGame({ values: { level }, seed });
  const moves: { x: number; y: number; steps: number }[] = [];
  sailHome(game, 15, () => {
    const [x, y] = [game.boat.engine, -game.boat.valve];
    const last = moves[moves.length - 1];
    if (last?.x === x && last.y === y) last.steps++;
    else moves.push({ x, y, steps: 1 });
  });
  if (game.boat.ending !== 'won') throw new Error(`The pilot does not win level ${level} of seed ${seed}.`);
  return moves;
}
