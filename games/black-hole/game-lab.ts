/** Games of black holes without a page, for tests: the ship is put where a test needs it. */
import { step } from '@principia/physics';
import { BLACK_HOLE } from '@principia/scenes';
import { BREATH } from './rules.ts';
import { type BlackHoleGame, createGame } from './sim.ts';

export const CLASSIC = { fuel: false, moving: false, steep: false, autopilot: false, level: 1 };

export function play(seed = 1, values: Partial<typeof CLASSIC> = {}): BlackHoleGame {
  return createGame({ values: { ...CLASSIC, ...values }, seed });
}

export function run(game: BlackHoleGame, seconds: number): void {
  const steps = Math.round(seconds / game.dt);
  for (let i = 0; i < steps; i++) step(game.world, game.dt);
}

/** Places the ship with a velocity. */
export function put(game: BlackHoleGame, x: number, y: number, vx = 0, vy = 0): void {
  const { Velocity } = game.world.components;
  game.scene.placeShip(x, y);
  Velocity.x[game.scene.ship] = vx;
  Velocity.y[game.scene.ship] = vy;
}

export function ship(game: BlackHoleGame) {
  const { Position, Velocity } = game.world.components;
  const id = game.scene.ship;
  return { x: Position.x[id], y: Position.y[id], vx: Velocity.x[id], vy: Velocity.y[id] };
}

/** Moves the first hole to the centre and returns its radius. */
export function centre({ scene }: BlackHoleGame): number {
  const { Position, Collider } = scene.world.components;
  Position.x[scene.holeIds[0]] = 400;
  Position.y[scene.holeIds[0]] = 300;
  return Collider.radius[scene.holeIds[0]];
}

/** Switches off the gravity and horizons of all holes. */
export function calm({ scene }: BlackHoleGame): void {
  for (const id of scene.holeIds) {
    scene.world.components.Attractor.mu[id] = 0;
    scene.world.components.Collider.radius[id] = 0;
  }
}

export function win(game: BlackHoleGame): void {
  calm(game);
  put(game, 400, BLACK_HOLE.goal - 0.1, 0, 50);
  step(game.world, game.dt);
}

export function fall(game: BlackHoleGame): void {
  const { Position } = game.world.components;
  const [id] = game.scene.holeIds;
  put(game, Position.x[id] + 0.8 * game.world.components.Collider.radius[id], Position.y[id]);
  step(game.world, game.dt);
}

/** Waits for the next ship and launches it. */
export function relaunch(game: BlackHoleGame): void {
  run(game, BREATH + 2 * game.dt);
  if (game.rules.phase !== 'ready') throw new Error(`The next ship is not ready: ${game.rules.phase}`);
  game.press('up');
  step(game.world, game.dt);
}
