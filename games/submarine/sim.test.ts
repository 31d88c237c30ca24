import { step } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { HULL } from './hull.ts';
import { currentAt, SHIP } from './sea.ts';
import { AIR, breathOf, createGame, type SubmarineGame } from './sim.ts';

const open = (level = 1, seed = 1) => createGame({ values: { level }, seed });

function run({ world, dt }: SubmarineGame, seconds: number): void {
  for (let i = 0; i < Math.round(seconds / dt); i++) step(world, dt);
}

function hold(game: SubmarineGame, name: string, seconds: number): void {
  game.press(name);
  run(game, seconds);
  game.release(name);
}

describe('the boat', () => {
  test('stands still when all is let go after a moment was restored', () => {
    const game = open();
    game.press('right');
    game.press('down');
    game.steer(0, 0);
    expect([game.boat.engine, Math.abs(game.boat.valve)]).toEqual([0, 0]);
  });

  test('floats with nine tenths of its hull under water', () => {
    const game = open();
    run(game, 60);
    // f = ½ + ½ d / H = m / ρ V = 0.9.
    expect(game.depth).toBeCloseTo(0.8 * HULL.halfHeight, 3);
    expect(game.ratio).toBeCloseTo(0.9, 3);
  });

  test('runs at the speed at which drag balances the propeller', () => {
    const game = open();
    hold(game, 'down', 0.6);
    run(game, 3);
    hold(game, 'right', 12);
    // √(T / k) under water; 20 tanh-like approach within a thousandth after 12 s.
    const { x } = game.world.components.Velocity;
    expect(x[game.sub]).toBeCloseTo(Math.sqrt(HULL.thrust / HULL.drag), 1);
  });

  test('is pressed together by depth, so that the neutral fill falls', () => {
    const game = open();
    const { Position, Mass } = game.world.components;
    Mass.value[game.sub] = 61_500;
    Position.y[game.sub] = -100;
    expect(game.ratio).toBeCloseTo(1 / (1 - 0.006), 9);
    expect(game.pressure).toBeCloseTo(1 + (1025 * 9.81 * 100) / 101_325, 9);
  });

  test('blows its tank with air of the pressure of the depth', () => {
    const game = open();
    game.world.components.Position.y[game.sub] = -30;
    game.boat.fill = 0.5;
    game.press('up');
    step(game.world, game.dt);
    const blown = 0.5 - game.boat.fill;
    expect(AIR.full - game.boat.air).toBeCloseTo(blown * HULL.volume * (1 + (1025 * 9.81 * 30) / 101_325), 2);
  });

  test('drifts with the current', () => {
    const game = open(5);
    game.world.components.Position.x[game.sub] = 300;
    game.world.components.Position.y[game.sub] = -38;
    game.boat.fill = 0.5 - 0.00228;
    run(game, 20);
    // The speed approaches that of the water as 1/t.
    const { x } = game.world.components.Velocity;
    expect(x[game.sub]).toBeGreaterThan(0.6 * currentAt(game.sea, game.depth));
    expect(x[game.sub]).toBeLessThan(currentAt(game.sea, 38) + 0.01);
  });
});

describe('the mission', () => {
  test('is won with all crates at the ship', () => {
    const game = open();
    const { Position, Velocity } = game.world.components;
    for (let i = 0; i < game.taken.length; i++) {
      Position.x[game.sub] = game.sea.crates[2 * i];
      Position.y[game.sub] = game.sea.crates[2 * i + 1] + 4;
      Velocity.x[game.sub] = Velocity.y[game.sub] = 0;
      run(game, 0.1);
    }
    expect(game.boat).toMatchObject({ collected: 3, ending: 'none' });
    Position.x[game.sub] = SHIP.x;
    Position.y[game.sub] = -1.8;
    run(game, 0.1);
    expect(game.boat.ending).toBe('won');
    expect(game.score()).toBeGreaterThan(500);
  });

  test('is lost below the crush depth, by knocks, and without breath', () => {
    const deep = open();
    deep.world.components.Position.y[deep.sub] = -deep.sea.crushDepth - 60;
    deep.world.components.Position.x[deep.sub] = 300;
    deep.boat.fill = 1;
    run(deep, 6);
    expect(deep.boat.ending).toBe('crushed');
    const wreck = open();
    for (let i = 0; i < 12 && wreck.boat.ending === 'none'; i++) {
      wreck.world.components.Velocity.x[wreck.sub] = -8;
      run(wreck, 8);
    }
    expect(wreck.boat.ending).toBe('wrecked');
    const idle = open();
    // Air to breathe is used up below the surface only.
    run(idle, 320);
    expect(idle.boat).toMatchObject({ ending: 'none', breath: breathOf(1) });
    // Half full the tank hovers.
    idle.world.components.Position.y[idle.sub] = -10;
    idle.boat.fill = 0.5;
    run(idle, 320);
    expect(idle.boat.ending).toBe('suffocated');
  });

  test.each([1, 2, 5, 9])('level %i can be sailed: the bed is below the surface and above the crush depth', (level) => {
    for (const seed of [1, 2, 3]) {
      const { sea } = open(level, seed);
      for (let i = 1; i < sea.bed.length; i += 2) {
        expect(sea.bed[i]).toBeLessThan(-15);
        expect(sea.bed[i]).toBeGreaterThan(-sea.crushDepth);
      }
      expect(new Set(sea.crates).size).toBeGreaterThan(sea.crates.length / 2);
    }
  });
});
