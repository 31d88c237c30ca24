import { energy, step } from '@principia/physics';
import { describe, expect, it, test } from 'vitest';
import { Flight } from './flight.ts';
import { CLASSIC, calm, centre, fall, play, put, relaunch, run, ship, win } from './game-lab.ts';
import { DIRECTIONS, thrustOf } from './heading.ts';
import { BREATH, TANK } from './rules.ts';
import { applyValue, type BlackHoleGame, createGame, IDLE_SECONDS, type Input } from './sim.ts';

/** Pseudo-random inputs that cause some falls, exits and wins. */
function pressRandomly(game: BlackHoleGame, seconds: number): void {
  const inputs: Input[] = ['up', 'left', 'release', 'up', 'right', 'down', 'up', 'release', 'redraw', 'up'];
  for (let i = 0; i < seconds * 2; i++) {
    game.press(inputs[(i * 7 + (i >> 3)) % inputs.length]);
    run(game, 0.5);
  }
}

describe('the laws', () => {
  it('the escape velocity at the horizon of any hole is the speed of light', () => {
    const game = play(3);
    game.press('up');
    for (let level = 1; level <= 12; level++) {
      const { Attractor, Collider } = game.world.components;
      expect(game.scene.holeIds).toHaveLength(level);
      for (const id of game.scene.holeIds) {
        expect(Math.sqrt((2 * Attractor.mu[id]) / Collider.radius[id])).toBeCloseTo(200, 9);
        expect(Collider.radius[id]).toBeLessThanOrEqual(30);
      }
      step(game.world, game.dt);
      win(game);
      relaunch(game);
    }
  });

  it.each([1, 2, 3, 4, 5, 6])('energy is conserved without thrust, layout %i', (seed) => {
    const game = play(seed);
    game.press('up');
    game.press('release');
    const { scene } = game;
    const start = energy(game.world).total;
    const own = () => {
      const { x, y, vx, vy } = ship(game);
      const depth = scene.holes.reduce((sum, h) => sum + (20_000 * h.radius) / Math.hypot(x - h.x, y - h.y), 0);
      return 0.5 * (vx * vx + vy * vy) - depth;
    };
    expect(own()).toBeCloseTo(start, 6);
    for (let i = 0; i < 3000 && game.rules.eventCount === 1; i++) {
      step(game.world, game.dt);
      const { x, y } = ship(game);
      if (scene.holes.some((h) => Math.hypot(x - h.x, y - h.y) < 2 * h.radius)) break;
      if (game.rules.eventCount === 1) expect(Math.abs(own() / start - 1)).toBeLessThan(1e-3);
    }
  });

  it('conserves the energy of a close orbit', () => {
    const game = play(1);
    game.press('up');
    game.press('release');
    step(game.world, game.dt);
    const radius = centre(game);
    const d = 2.2 * radius;
    put(game, 400 + d, 300, 0, Math.sqrt((20_000 * radius) / d));
    const start = energy(game.world).total;
    for (let i = 0; i < 600; i++) {
      step(game.world, game.dt);
      expect(Math.abs(energy(game.world).total / start - 1)).toBeLessThan(1e-3);
    }
    expect(game.rules.lives).toBe(3);
  });

  it('climbs 500 m in 10 s without gravity', () => {
    const game = play(1);
    calm(game);
    game.press('up');
    run(game, 9.99);
    expect(game.rules.score).toBe(0);
    expect(ship(game).vy).toBeCloseTo(1199 / 12, 6);
    run(game, 0.03);
    expect(game.rules.score).toBe(1);
  });

  it('the predicted flight agrees with the world', () => {
    const game = play(8, { moving: true });
    game.rules.dodged = 6;
    game.rules.redraw();
    expect(game.scene.holes.filter(({ orbit }) => orbit > 0)).toHaveLength(2);
    game.press('up');
    const flight = new Flight();
    flight.begin(ship(game), game.scene.holes, game.scene.holeTime);
    for (let i = 0; i < 240 && game.rules.lives === 3; i++) {
      step(game.world, game.dt);
      flight.step(game.dt, thrustOf(DIRECTIONS.up, { x: 0, y: 0 }));
    }
    expect(flight.x).toBeCloseTo(ship(game).x, 3);
    expect(flight.y).toBeCloseTo(ship(game).y, 3);
  });
});

describe('the rules', () => {
  it('waits for the first input', () => {
    const game = play(1);
    run(game, 3);
    expect(ship(game)).toEqual({ x: 400, y: 50, vx: 0, vy: 0 });
    expect(game.rules.phase).toBe('ready');
  });

  it('the last key pressed counts, and releasing a key stops the engine', () => {
    const game = play(1);
    const { Thrust } = game.world.components;
    const pushed = (input: Input) => {
      game.press(input);
      step(game.world, game.dt);
      return [Thrust.x[game.scene.ship], Thrust.y[game.scene.ship]];
    };
    expect(pushed('up')).toEqual([0, 10]);
    expect(pushed('left')).toEqual([-10, 0]);
    expect(pushed('right')).toEqual([10, 0]);
    expect(pushed('down')).toEqual([0, -10]);
    expect(pushed('release')).toEqual([0, 0]);
  });

  it('gives n (n + 1) / 2 points for n levels, and one more hole each', () => {
    const game = play(5);
    game.press('up');
    step(game.world, game.dt);
    for (let n = 1; n <= 10; n++) {
      expect(game.scene.holes).toHaveLength(n);
      win(game);
      expect([game.rules.score, game.rules.dodged]).toEqual([(n * (n + 1)) / 2, n]);
      relaunch(game);
    }
    expect(game.rules.bonus).toBe(0);
  });

  it('a fall costs one life, also where holes overlap, and the third ends the game', () => {
    const game = play(2);
    game.press('up');
    step(game.world, game.dt);
    win(game);
    relaunch(game);
    win(game);
    for (const lives of [2, 1, 0]) {
      relaunch(game);
      const { Position } = game.world.components;
      const [a, ...others] = game.scene.holeIds;
      for (const id of others) {
        Position.x[id] = Position.x[a];
        Position.y[id] = Position.y[a];
      }
      fall(game);
      expect(game.rules.lives).toBe(lives);
    }
    expect(game.rules.phase).toBe('over');
    const hash = game.hash();
    game.press('up');
    game.press('redraw');
    run(game, 2);
    expect(game.hash()).toBe(hash);
  });

  it('leaving the stage costs nothing and keeps the holes', () => {
    for (const [x, y, vx, vy] of [
      [1, 300, -200, 0],
      [799, 300, 200, 0],
      [400, 1, 0, -200],
    ]) {
      const game = play(2);
      game.press('release');
      game.press('up');
      step(game.world, game.dt);
      const { holes } = game.scene;
      calm(game);
      put(game, x, y, vx, vy);
      step(game.world, game.dt);
      run(game, BREATH + game.dt);
      expect(ship(game)).toEqual({ x: 400, y: 50, vx: 0, vy: 0 });
      expect(game.scene.holes).toBe(holes);
      expect([game.rules.lives, game.rules.score]).toEqual([3, 0]);
    }
  });

  it('layout changes are free and unlimited, reset the ship, and cancel the bonus of the level', () => {
    const game = play(2, { fuel: true });
    game.press('up');
    step(game.world, game.dt);
    win(game);
    relaunch(game);
    const wish = () => {
      const { holes } = game.scene;
      game.press('redraw');
      step(game.world, game.dt);
      expect(game.scene.holes).not.toBe(holes);
      expect(game.scene.holes).toHaveLength(2);
      const { x, y } = ship(game);
      expect(Math.hypot(x - 400, y - 50)).toBeLessThan(0.01);
      return [game.rules.goalPoints, game.rules.lives, game.rules.score];
    };
    const { bonus } = game.rules;
    expect(bonus).toBeGreaterThan(0);
    for (let i = 0; i < 5; i++) expect(wish()).toEqual([2, 3, 1]);
    game.press('up');
    step(game.world, game.dt);
    win(game);
    expect([game.rules.score, game.rules.goalPoints, game.rules.bonus]).toEqual([3, 3, bonus]);
    relaunch(game);
    win(game);
    expect(game.rules.bonus).toBeGreaterThan(bonus);
  });
});

describe('fuel, slingshots, moving holes', () => {
  it('an empty tank gives no thrust', () => {
    const game = play(1, { fuel: true });
    calm(game);
    put(game, 400, 50);
    game.press('down');
    step(game.world, game.dt);
    game.rules.fuel = 0.5 * TANK;
    game.press('right');
    put(game, 10, 300);
    run(game, 5);
    expect(game.rules.fuel).toBeCloseTo(0.5 * TANK - 50, 6);
    game.rules.fuel = 0.01;
    run(game, 0.1);
    const { vx } = ship(game);
    run(game, 0.3);
    expect(ship(game).vx).toBe(vx);
    expect(game.rules.events.filter(({ kind }) => kind === 'empty')).toHaveLength(1);
  });

  it('counts a slingshot once, and pays at the goal', () => {
    const game = play(1, { fuel: true });
    game.press('up');
    game.press('release');
    step(game.world, game.dt);
    const radius = centre(game);
    calm(game);
    game.world.components.Collider.radius[game.scene.holeIds[0]] = radius;
    put(game, 400 - 7 * radius, 300 - 2 * radius, 100, 0);
    run(game, (15 * radius) / 100);
    expect(game.rules.slings).toBe(1);
    win(game);
    expect([game.rules.score, game.rules.bonus, game.rules.slingshots]).toEqual([1, 1 + 5, 1]);
    game.rules.restart();
    expect(game.rules.slingshots).toBe(0);
  });

  it('holes move on circles from level 5 on', () => {
    const game = play(4, { moving: true });
    game.press('up');
    game.press('release');
    step(game.world, game.dt);
    for (let i = 0; i < 4; i++) {
      win(game);
      relaunch(game);
    }
    expect(game.scene.holes.map(({ orbit }) => orbit > 0)).toEqual([true, false, false, false, false]);
    const [hole] = game.scene.holes;
    const [id] = game.scene.holeIds;
    const { x, y } = game.world.components.Position;
    put(game, 400, 50);
    run(game, 1.5);
    if (game.rules.lives === 3) {
      expect(Math.hypot(x[id] - hole.x, y[id] - hole.y)).toBeCloseTo(hole.orbit, 6);
      expect(Math.hypot(x[id] - hole.x - hole.orbit * Math.cos(hole.phase), y[id] - hole.y)).toBeGreaterThan(1);
    }
  });
});

describe('determinism', () => {
  it('a replay from the log is bitwise identical', () => {
    const values = { fuel: true, moving: true, steep: false, autopilot: false };
    const game = createGame({ values, seed: 11 });
    run(game, 0.7);
    pressRandomly(game, 40);
    const again = createGame({ values, seed: 11, log: game.log.entries });
    run(again, 40.7);
    expect(again.hash()).toBe(game.hash());
    expect(game.rules.eventCount).toBeGreaterThan(4);
    const other = createGame({ values, seed: 12, log: game.log.entries });
    run(other, 40.7);
    expect(other.hash()).not.toBe(game.hash());
  });
});

describe('the autopilot', () => {
  test('takes over after a while, and the first key starts a new game', () => {
    const game = play(6);
    const fresh = game.scene.holes;
    run(game, IDLE_SECONDS + 8);
    expect(game.isDemo).toBe(true);
    game.press('up');
    run(game, 0.2);
    expect(game.isDemo).toBe(false);
    expect(game.scene.holes).toEqual(fresh);
    expect(game.rules).toMatchObject({ score: 0, lives: 3, phase: 'flying' });
  });

  test('wins levels', () => {
    let cleared = 0;
    for (let seed = 1; seed <= 4; seed++) {
      const game = play(seed, { autopilot: true, fuel: true, moving: true });
      for (let t = 0; t < 90 && game.rules.phase !== 'over' && game.rules.dodged < 3; t++) run(game, 1);
      cleared += game.rules.dodged;
    }
    expect(cleared).toBeGreaterThanOrEqual(8);
  }, 60_000);

  test('can be switched on and off while flying', () => {
    const game = play(6);
    expect(applyValue(game, 'autopilot', { ...CLASSIC, autopilot: true })).toBe(true);
    run(game, 0.5);
    expect(game.rules.phase).toBe('flying');
    applyValue(game, 'autopilot', CLASSIC);
    run(game, 0.1);
    expect(game.rules.push).toBeUndefined();
    expect(applyValue(game, 'moving', CLASSIC)).toBe(false);
    expect(applyValue(game, 'lens', CLASSIC)).toBe(true);
  });
});
