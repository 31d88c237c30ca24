import { step } from '@principia/physics';
import { BLACK_HOLE } from '@principia/scenes';
import { describe, expect, it, test } from 'vitest';
import { Flight } from './flight.ts';
import { calm, fall, play, run, ship } from './game-lab.ts';
import { pushOf } from './heading.ts';
import { opensToOneKey } from './one-key-flight.ts';
import { BREATH } from './rules.ts';
import { IDLE_SECONDS } from './sim.ts';

test.each(['up', 'left', 'down', 'right'] as const)(
  'who just holds %s never clears a level, in Newtonian and in relativistic gravity',
  (key) => {
    for (const steep of [false, true]) {
      for (let seed = 1; seed <= 60; seed++) {
        const game = play(seed, { steep });
        expect(opensToOneKey(game.scene.holes, steep)).toBe(false);
        const end = () => game.rules.events.find(({ kind }) => kind === 'goal' || kind === 'fall' || kind === 'left');
        game.press(key);
        // Unobstructed a climb takes 10 s.
        while (end() === undefined && game.world.time < 100) step(game.world, game.dt);
        expect(end()?.kind, `seed ${seed}`).toMatch(/fall|left/);
      }
    }
  },
  60_000,
);

test('who waits below moving holes and then only climbs falls or is lost, too', () => {
  const ends: string[] = [];
  for (const [level, seed] of [5, 7].flatMap((level) => [1, 2, 3, 4, 5, 6].map((seed) => [level, seed]))) {
    const { holes } = play(seed, { level, moving: true }).scene;
    const flight = new Flight();
    for (let wait = 0; wait < 9; wait += 0.75) {
      flight.begin({ ...BLACK_HOLE.start, vx: 0, vy: 0 }, holes, wait);
      while (flight.status === 'flying') flight.step(1 / 120, { x: 0, y: BLACK_HOLE.thrust });
      if (flight.status === 'goal') ends.push(`level ${level}, seed ${seed}, after ${wait} s`);
    }
  }
  expect(ends).toEqual([]);
}, 60_000);

describe('the breath between two flights', () => {
  it('keeps the ship where it ended with its engine off, and waits for a new input', () => {
    const game = play(2);
    game.press('up');
    step(game.world, game.dt);
    fall(game);
    const { x, y } = ship(game);
    run(game, 0.5 * BREATH);
    expect(game.rules).toMatchObject({ phase: 'breath', lives: 2, push: undefined });
    expect(ship(game)).toMatchObject({ x, y });
    // The key that is still held sends nothing, and one that is pressed too early is ignored.
    game.press('up');
    run(game, BREATH);
    expect(game.rules.phase).toBe('ready');
    run(game, 2);
    expect(ship(game)).toEqual({ x: 400, y: 50, vx: 0, vy: 0 });
    game.press('up');
    run(game, 0.1);
    expect(game.rules.phase).toBe('flying');
  });

  it('does not start the demo while somebody plays', () => {
    const game = play(2);
    game.press('up');
    step(game.world, game.dt);
    fall(game);
    run(game, IDLE_SECONDS + 5);
    expect(game.isDemo).toBe(false);
    expect(game.rules.lives).toBe(2);
  });
});

describe('analogue thrust', () => {
  it('points anywhere, at any strength up to full thrust, and spends fuel accordingly', () => {
    const game = play(1, { fuel: true });
    const { Thrust } = game.world.components;
    calm(game);
    for (const [x, y] of [
      [0.5, 0],
      [-0.6, 0.8],
      [3, -4],
    ]) {
      game.steer(x, y);
      const before = game.rules.fuel;
      step(game.world, game.dt);
      const size = Math.hypot(x, y);
      const full = 10 / Math.max(1, size);
      expect(Thrust.x[game.scene.ship]).toBeCloseTo(full * x, 9);
      expect(Thrust.y[game.scene.ship]).toBeCloseTo(full * y, 9);
      expect(before - game.rules.fuel).toBeCloseTo(10 * Math.min(1, size) * game.dt, 9);
    }
    game.steer(0, 0);
    step(game.world, game.dt);
    expect(Thrust.x[game.scene.ship]).toBe(0);
  });

  it('is rounded alike in all directions', () => {
    for (const [x, y] of [
      [0.33, 0.77],
      [0.025, 0.975],
      [2, 1],
    ]) {
      const { x: px, y: py } = pushOf(x, y) ?? { x: 0, y: 0 };
      for (const [sx, sy] of [
        [1, -1],
        [-1, 1],
        [-1, -1],
      ]) {
        expect(pushOf(sx * x, sy * y)).toEqual({ x: sx * px || 0, y: sy * py || 0 });
      }
      expect(pushOf(y, x)).toEqual({ x: py, y: px });
    }
  });
});
