/** The levels can be won: a pilot with the player's four keys does it, in time and with the air it has. */
import { expect, test } from 'vitest';
import { createGame } from './sim.ts';
import { sailHome } from './test-pilot.ts';

test.each([1, 2, 3, 4, 5, 6, 7, 8, 9])(
  'level %i is won',
  (level) => {
    const game = createGame({ values: { level }, seed: 1 });
    sailHome(game, 3);
    expect(game.boat).toMatchObject({ ending: 'won', collected: game.taken.length });
    expect(game.boat.breath).toBeGreaterThan(20);
  },
  30_000,
);
