/** The levels can be won: a pilot with the player's four keys does it, in time and with the air it has. */
import { step } from '@principia/physics';
import { expect, test } from 'vitest';
import { SHIP } from './sea.ts';
import { createGame, type SubmarineGame } from './sim.ts';

/** Depth on the way, m: at the surface, where the air is filled up. */
const CRUISE = 0.5;
/** Air with which one may dive, m³, fastest ways down and up, m/s, and how near a crate has to be, m. */
const [ENOUGH, DOWN, UP] = [900, 4, 4.5];
const [BESIDE, ABOVE] = [3, 5.5];

/** Presses and releases the keys that lead to a place. */
function steer(game: SubmarineGame, x: number, depth: number): void {
  const { Position, Velocity } = game.world.components;
  const id = game.sub;
  const sinking = -Velocity.y[id];
  const wanted = Math.max(-UP, Math.min(DOWN, 0.25 * (depth - game.depth)));
  // More weight than neutral for the speed that is missing.
  const fill = 0.5 - 6e-5 * Math.max(0, game.depth) + 0.06 * (wanted - sinking) + 0.014 * wanted * Math.abs(wanted);
  const error = Math.max(0, Math.min(1, fill)) - game.boat.fill;
  if (Math.abs(error) < 0.04) game.release('up');
  else game.press(error > 0 ? 'down' : 'up');
  const push = 0.25 * (x - Position.x[id]) - Velocity.x[id];
  if (Math.abs(push) < 0.4) game.release('left');
  else game.press(push > 0 ? 'right' : 'left');
}

function sail(game: SubmarineGame, x: number, depth: number, isThere: () => boolean): void {
  for (let i = 0; i < 60 * 120 && !isThere() && !game.isOver; i++) {
    if (i % 3 === 0) steer(game, x, depth);
    step(game.world, game.dt);
  }
}

test.each([1, 2, 3, 4, 5, 6, 7, 8, 9])(
  'level %i is won',
  (level) => {
    const game = createGame({ values: { level }, seed: 1 });
    const { Position } = game.world.components;
    const near = (x: number, reach: number) => () => Math.abs(Position.x[game.sub] - x) < reach;
    for (let i = 0; i < game.taken.length; i++) {
      const [x, y] = [game.sea.crates[2 * i], game.sea.crates[2 * i + 1]];
      sail(game, x, CRUISE, near(x, BESIDE));
      sail(game, x, -y - ABOVE, () => game.taken[i] === 1);
      // Straight up if the air will not do for another dive.
      sail(game, x, CRUISE, () => game.boat.air >= ENOUGH);
    }
    sail(game, SHIP.x, CRUISE, near(SHIP.x, 6));
    sail(game, SHIP.x, -1, () => game.isOver);
    expect(game.boat).toMatchObject({ ending: 'won', collected: game.taken.length });
    expect(game.boat.breath).toBeGreaterThan(20);
  },
  30_000,
);
