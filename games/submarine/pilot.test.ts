/** The levels can be won: a pilot with the player's four keys does it, in time and with the air it has. */
import { step } from '@principia/physics';
import { expect, test } from 'vitest';
import { SHIP } from './sea.ts';
import { createGame, type SubmarineGame } from './sim.ts';

const CRUISE = 20;

/** Presses and releases the keys that lead to a place. */
function steer(game: SubmarineGame, x: number, depth: number): void {
  const { Position, Velocity } = game.world.components;
  const id = game.sub;
  const sinking = -Velocity.y[id];
  const wanted = Math.max(-2.2, Math.min(2.2, 0.22 * (depth - game.depth)));
  // More weight than neutral for the speed that is missing.
  const fill = 0.5 - 6e-5 * Math.max(0, game.depth) + 0.06 * (wanted - sinking) + 0.014 * wanted * Math.abs(wanted);
  const error = Math.max(0, Math.min(1, fill)) - game.boat.fill;
  if (Math.abs(error) < 0.012) game.release('up');
  else game.press(error > 0 ? 'down' : 'up');
  const push = 0.25 * (x - Position.x[id]) - Velocity.x[id];
  if (Math.abs(push) < 0.4) game.release('left');
  else game.press(push > 0 ? 'right' : 'left');
}

function sail(game: SubmarineGame, x: number, depth: number, isThere: () => boolean): void {
  for (let i = 0; i < 60 * 120 && !isThere() && !game.isOver; i++) {
    if (i % 6 === 0) steer(game, x, depth);
    step(game.world, game.dt);
  }
}

test.each([1, 3])(
  'level %i is won',
  (level) => {
    const game = createGame({ values: { level }, seed: 1 });
    const { Position } = game.world.components;
    const near = (x: number, reach: number) => () => Math.abs(Position.x[game.sub] - x) < reach;
    for (let i = 0; i < game.taken.length; i++) {
      const [x, y] = [game.sea.crates[2 * i], game.sea.crates[2 * i + 1]];
      sail(game, x, CRUISE, near(x, 4));
      sail(game, x, -y - 5, () => game.taken[i] === 1);
    }
    sail(game, SHIP.x, CRUISE, near(SHIP.x, 6));
    sail(game, SHIP.x, -1, () => game.isOver);
    expect(game.boat).toMatchObject({ ending: 'won', collected: game.taken.length });
    expect(game.boat.breath).toBeGreaterThan(20);
  },
  30_000,
);
