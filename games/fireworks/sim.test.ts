import { restore, snapshot, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { PlayerControls } from './controls.ts';
import { DEMO_SHOW } from './demo-show.ts';
import { quantize } from './show.ts';
import { createGame, type FireworksGame, type Input, MAX_HOLD_SECONDS, RANDOM, SWARM } from './sim.ts';

const VALUES = { wind: 0, barrage: false, sparks: 1000 };

function night(own: Partial<Parameters<typeof createGame>[0]> = {}): FireworksGame {
  return createGame({ values: VALUES, seed: 3, dimensions: 2, ...own });
}

function run(game: FireworksGame, seconds: number): void {
  for (let i = Math.round(seconds / game.dt); i > 0; i--) step(game.world, game.dt);
}

const fire = (finger: number, x = 10, y = 30): Input => ({ do: 'fire', finger, x, y, z: 0, kind: 0, color: 1 });

describe('a hand', () => {
  it('makes a shell the larger the longer it holds, up to a limit', () => {
    const powers = [0, 0.5 * MAX_HOLD_SECONDS, MAX_HOLD_SECONDS, 3 * MAX_HOLD_SECONDS].map((seconds) => {
      const game = night();
      game.press({ do: 'hold', finger: 1 });
      run(game, game.dt + seconds);
      game.press(fire(1));
      run(game, game.dt);
      return game.scene.events.at(0).power;
    });
    expect(powers[0]).toBeLessThan(0.4);
    expect(powers[1]).toBeCloseTo((powers[0] + 1) / 2, 1);
    expect(powers.slice(2)).toEqual([1, 1]);
  });

  it('that lets go and presses again within a step begins anew, in the sky and in the show being made', () => {
    const game = night();
    const controls = new PlayerControls('');
    controls.toggleEditing(game);
    controls.choose(0, 1);
    controls.startHold(game, 1);
    run(game, 2 * MAX_HOLD_SECONDS);
    controls.fire(game, 1, { x: 10, y: 30, z: 0 });
    controls.startHold(game, 1);
    controls.fire(game, 1, { x: -10, y: 30, z: 0 });
    run(game, game.dt);
    const sent = [0, 1].map((i) => game.scene.events.at(i));
    expect(sent[0].power).toBe(1);
    expect(sent[1].power).toBeLessThan(0.4);
    expect(controls.editor.cues.map(({ power }) => power)).toEqual(
      sent.map(({ x, y, z, kind, color, power }) => quantize({ x, y, z, kind, color, power, tick: 0 }).power),
    );
  });

  it('of ten fingers sends up ten shells, each where it points', () => {
    const game = night();
    for (let finger = 0; finger < 10; finger++) game.press({ do: 'hold', finger });
    run(game, 0.2);
    expect(game.held.size).toBe(10);
    for (let finger = 0; finger < 10; finger++) game.press(fire(finger, 9 * finger - 40));
    run(game, game.dt);
    expect([game.held.size, game.scene.flying, game.fired]).toEqual([0, 10, 10]);
  });

  it('that points beside the sky hits its nearest place, and never throws a shell that cannot fly', () => {
    const game = night();
    for (const [x, y] of [
      [1e9, -1e9],
      [-1e9, 1e9],
      [0, 0],
    ])
      game.press(fire(1, x, y));
    run(game, 6);
    expect(game.world.faults.faults).toEqual([]);
    const bursts = Array.from({ length: game.scene.events.count }, (_, i) => game.scene.events.at(i));
    const places = bursts.filter(({ type }) => type === 'burst').map(({ x, y }) => [Math.round(x), Math.round(y)]);
    expect(places.sort(([a], [b]) => a - b)).toEqual([
      [-80, 100],
      [0, 6],
      [80, 6],
    ]);
  });

  it('with more shells than there are mortars loses the rest, and can fire again later', () => {
    const game = night();
    for (let i = 0; i < 40; i++) game.press(fire(1));
    run(game, game.dt);
    expect([game.scene.flying, game.refused]).toEqual([28, 12]);
    run(game, 5);
    game.press(fire(1));
    run(game, game.dt);
    expect([game.scene.flying, game.refused]).toEqual([1, 12]);
  });

  it('aims by keys: the sight moves at 30 m/s as long as one is held, and not beyond the sky', () => {
    const game = night();
    game.press({ do: 'steer', way: 'left', on: true });
    run(game, 1);
    game.press({ do: 'steer', way: 'left', on: false });
    run(game, 1);
    expect(game.crosshair.x).toBeCloseTo(-30, 9);
    game.press({ do: 'steer', way: 'up', on: true });
    run(game, 2);
    expect(game.crosshair.y).toBe(50);
  });
});

describe('a swarm', () => {
  const letGo: Input = { do: 'fire', finger: 1, x: -12, y: 28, z: 0, kind: SWARM, color: 0 };
  const hold = (game: FireworksGame, seconds: number) => {
    game.press({ do: 'hold', finger: 1 });
    run(game, seconds);
    game.press(letGo);
  };

  it.each([
    [0, 0],
    [0.4, 0],
    [0.9, 0],
    [1, 2],
    [1.9, 2],
    [2, 4],
    [2.5, 4],
    [3, 6],
    [5, 10],
    [60, 10],
  ])('that is held for %d s has 2 ⌊s⌋ stars where the hand is: %i, ten at most', (seconds, stars) => {
    const game = night();
    hold(game, seconds);
    run(game, game.dt);
    expect([game.scene.alive, game.scene.flying, game.refused]).toEqual([stars, 0, 0]);
    expect(game.fired).toBe(stars > 0 ? 1 : 0);
    const { count } = game.scene.events;
    expect(count).toBe(stars > 0 ? 1 : 0);
    if (count > 0) expect(game.scene.events.at(0)).toMatchObject({ type: 'burst', x: -12, y: 28, kind: SWARM });
  });

  it('bursts for six seconds from the moment it is let go, however long the night has lasted', () => {
    for (const waited of [0, 7, 20]) {
      const game = night();
      run(game, waited);
      hold(game, 2);
      run(game, 2);
      // Nobody ends before two seconds; from four seconds on all are children.
      expect(game.scene.alive).toBeGreaterThanOrEqual(4);
      run(game, 2.1);
      expect(game.scene.alive).toBeGreaterThanOrEqual(16);
      run(game, 6);
      expect(game.scene.alive).toBe(0);
    }
  });

  it('is no surprise: a click that draws its shell always sends one up', () => {
    for (let seed = 1; seed <= 3; seed++) {
      const game = night({ seed });
      for (let i = 0; i < 28; i++) game.press({ ...letGo, kind: RANDOM });
      run(game, game.dt);
      expect(game.scene.flying).toBe(28);
    }
  });
});

describe('a show', () => {
  const cues = [0, 30, 30, 90].map((tick, i) => ({ tick, x: 8 * i, y: 20 + i, z: 0, kind: i, color: i, power: 0.3 }));

  it('sends up each shell at its time, and ends', () => {
    const game = night();
    game.press({ do: 'play', cues });
    run(game, 3);
    const { events } = game.scene;
    const launches = Array.from({ length: events.count }, (_, i) => ({ ...events.at(i) })).filter(
      (n) => n.type === 'launch',
    );
    expect(launches.map(({ time }) => Math.round(60 * time))).toEqual(cues.map(({ tick }) => tick));
    expect(launches.map(({ kind }) => kind)).toEqual([0, 1, 2, 3]);
    expect(game.isShowing).toBe(false);
  });

  it('that only demonstrates begins again and again, until somebody fires', () => {
    const game = night({ opening: cues, isDemo: true });
    run(game, 1.5 + 5.5 + 0.2);
    expect(game.isShowing).toBe(true);
    game.press(fire(1));
    run(game, game.dt);
    expect([game.isShowing, game.isDemo]).toEqual([false, false]);
  });

  it('of the game never asks for more shells than there are mortars', () => {
    for (const dimensions of [2, 3] as const) {
      const game = night({ opening: DEMO_SHOW, isDemo: true, dimensions });
      run(game, 40);
      expect(game.refused).toBe(0);
      expect(game.world.faults.faults).toEqual([]);
    }
  });
});

describe('a night', () => {
  const surprise: Input = { do: 'fire', finger: 2, x: -20, y: 35, z: 4, kind: RANDOM, color: RANDOM };
  const inputs: [number, Input][] = [
    [5, { do: 'hold', finger: 2 }],
    [40, surprise],
    [41, { do: 'wind', speed: 7 }],
    [60, { do: 'steer', way: 'right', on: true }],
    [90, { do: 'colors', colors: [1, 2, 3, 4, 5, 6, 7, 8] }],
    [100, surprise],
    [130, { do: 'play', cues: DEMO_SHOW }],
  ];
  const play = (game: FireworksGame, from: number, to: number) => {
    for (let tick = from; tick < to; tick++) {
      for (const [at, input] of inputs) if (at === tick) game.press(input);
      step(game.world, game.dt);
    }
  };

  it('is the same to the bit when its log is played, in 2D and in 3D', () => {
    for (const dimensions of [2, 3] as const) {
      const game = night({ dimensions });
      play(game, 0, 700);
      const again = night({ dimensions, log: game.log.entries });
      run(again, 700 / 60);
      expect(again.hash()).toBe(game.hash());
      expect(night({ dimensions }).hash()).not.toBe(game.hash());
    }
  });

  it('goes back in time: what comes after is the same again', () => {
    const game = night({ values: { ...VALUES, barrage: true } });
    play(game, 0, 95);
    const taken = snapshot(game.world);
    play(game, 95, 600);
    const hash = game.hash();
    restore(game.world, taken);
    expect(game.world.tick).toBe(95);
    play(game, 95, 600);
    expect(game.hash()).toBe(hash);
  });
});
