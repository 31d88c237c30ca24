/** A pilot with the player's four keys, with whom tests sail the levels. */
import { step } from '@principia/physics';
import { SHIP } from './sea.ts';
import type { SubmarineGame } from './sim.ts';

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

/**
 * Brings up all crates and comes home.
 * @param reaction steps between two looks at the gauges
 * @param onStep called before every step
 */
export function sailHome(game: SubmarineGame, reaction: number, onStep: () => void = () => {}): void {
  const { Position } = game.world.components;
  const sail = (x: number, depth: number, isThere: () => boolean) => {
    for (let i = 0; i < 60 * 120 && !isThere() && !game.isOver; i++) {
      if (i % reaction === 0) steer(game, x, depth);
      onStep();
      step(game.world, game.dt);
    }
  };
  const near = (x: number, reach: number) => () => Math.abs(Position.x[game.sub] - x) < reach;
  for (let i = 0; i < game.taken.length; i++) {
    const [x, y] = [game.sea.crates[2 * i], game.sea.crates[2 * i + 1]];
    sail(x, CRUISE, near(x, BESIDE));
    sail(x, -y - ABOVE, () => game.taken[i] === 1);
    // Straight up if the air will not do for another dive.
    sail(x, CRUISE, () => game.boat.air >= ENOUGH);
  }
  sail(SHIP.x, CRUISE, near(SHIP.x, 6));
  sail(SHIP.x, -1, () => game.isOver);
}
