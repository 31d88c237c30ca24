import { restore, snapshot, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { Autopilot } from './autopilot.ts';
import { type BestFlight, BestFlights, layoutKey, MAX_FLIGHTS } from './best-flights.ts';
import { PATH_UNIT, SAMPLE_STEPS } from './flight-record.ts';
import { BlackHoleGame } from './sim.ts';

const VALUES = { fuel: true, moving: true, steep: false, autopilot: false };
const flight = (layout: string, steps: number): BestFlight => ({
  layout,
  steps,
  path: Array.from({ length: 2 * Math.ceil(steps / SAMPLE_STEPS) }, (_, i) => i),
});

function memoryStore(text?: string) {
  const values = new Map<string, string>();
  return {
    getItem: () => values.get('all') ?? text ?? null,
    setItem: (_: string, value: string) => void values.set('all', value),
  };
}

/** A game that wins its first level, as a player would. @param watch is called after each step */
function wonGame(seed: number, watch: (game: BlackHoleGame) => void = () => {}): BlackHoleGame {
  const game = new BlackHoleGame({ values: VALUES, seed });
  const pilot = new Autopilot(game.scene, 99);
  for (let tick = 0; game.rules.dodged === 0; tick++) {
    if (tick > 6000) throw new Error(`The bot does not win the first level of seed ${seed}.`);
    // A hand is no faster than a quarter of a second.
    if (tick % 30 === 0) game.press(tick === 0 ? 'up' : (pilot.steer(30 * game.dt) ?? 'release'));
    step(game.world, game.dt);
    watch(game);
  }
  return game;
}

describe('the record of a flight', () => {
  it('has the ship every tenth of a second, to half a unit, from the launch to the goal', () => {
    const places: number[] = [];
    const game = wonGame(4, ({ rules, scene, world }) => {
      if (rules.phase !== 'flying') return;
      places.push(world.components.Position.x[scene.ship], world.components.Position.y[scene.ship]);
    });
    const path = game.rules.record.path() as number[];
    // The step that reaches the goal ends the flight, so it is the record's last and not among the places.
    expect(game.rules.record.steps).toBe(places.length / 2 + 1);
    expect(path.length).toBe(2 * Math.ceil(game.rules.record.steps / SAMPLE_STEPS));
    // A last sample on the goal itself has no counterpart.
    const known = path.slice(0, 2 * Math.ceil(places.length / 2 / SAMPLE_STEPS));
    for (const [i, value] of known.entries()) {
      const sample = Math.floor(i / 2) * SAMPLE_STEPS;
      // Half a unit of rounding, and the 6e-8 × 800 m of a column in f32.
      expect(Math.abs(value * PATH_UNIT - places[2 * sample + (i % 2)])).toBeLessThan(PATH_UNIT / 2 + 1e-4);
    }
  });

  it('goes back with the world, and forgets the flight before', () => {
    const game = new BlackHoleGame({ values: VALUES, seed: 4 });
    game.press('up');
    for (let i = 0; i < 60; i++) step(game.world, game.dt);
    const taken = snapshot(game.world);
    const before = game.rules.record.path();
    for (let i = 0; i < 60; i++) step(game.world, game.dt);
    expect(game.rules.record.path()).not.toEqual(before);
    restore(game.world, taken);
    expect(game.rules.record.path()).toEqual(before);
    game.press('redraw');
    step(game.world, game.dt);
    expect(game.rules.record.steps).toBe(0);
  });

  it('does not count where the autopilot steers', () => {
    const game = new BlackHoleGame({ values: { ...VALUES, autopilot: true }, seed: 4 });
    for (let i = 0; i < 120; i++) step(game.world, game.dt);
    expect(game.rules.record.steps).toBeGreaterThan(0);
    expect(game.rules.record.path()).toBeUndefined();
  });
});

describe('the best flights', () => {
  it('keep the fastest of a layout, and find it after a reload', () => {
    const store = memoryStore();
    const flights = new BestFlights(store);
    flights.offer(flight('a', 500));
    flights.offer(flight('a', 400));
    flights.offer(flight('a', 450));
    flights.offer(flight('b', 900));
    expect(new BestFlights(store).find('a')).toEqual(flight('a', 400));
    expect(new BestFlights(store).find('b')?.steps).toBe(900);
  });

  it('keep those that another tab has flown since', () => {
    const store = memoryStore();
    const [one, other] = [new BestFlights(store), new BestFlights(store)];
    one.offer(flight('a', 400));
    other.offer(flight('b', 900));
    other.offer(flight('a', 500));
    expect(new BestFlights(store).find('a')?.steps).toBe(400);
    expect(new BestFlights(store).find('b')?.steps).toBe(900);
  });

  it('are bounded: the oldest is forgotten', () => {
    const flights = new BestFlights(memoryStore());
    for (let i = 0; i <= MAX_FLIGHTS; i++) flights.offer(flight(`layout ${i}`, 100));
    expect(flights.find('layout 0')).toBeUndefined();
    expect(flights.find('layout 1')).toBeDefined();
  });

  it.each([
    ['absent', undefined],
    [
      'full',
      {
        getItem: () => null,
        setItem: () => {
          throw new DOMException('full', 'QuotaExceededError');
        },
      },
    ],
    ['invalid', memoryStore('[{"layout":"a","steps":20,"path":[1]},7,{"layout":"b","steps":"x","path":[]}]')],
    ['not JSON', memoryStore('[[')],
  ])('last as long as the page where the storage is %s', (_, store) => {
    const flights = new BestFlights(store);
    expect(flights.find('a')).toBeUndefined();
    flights.offer(flight('a', 30));
    expect(flights.find('a')).toEqual(flight('a', 30));
  });

  it('tell layouts, pulls and tanks apart', () => {
    const { scene } = new BlackHoleGame({ values: VALUES, seed: 20261123 });
    const again = new BlackHoleGame({ values: VALUES, seed: 20261123 });
    const other = new BlackHoleGame({ values: VALUES, seed: 20261124 });
    const key = layoutKey(scene.holes, false, true);
    expect(layoutKey(again.scene.holes, false, true)).toBe(key);
    const others = [
      layoutKey(other.scene.holes, false, true),
      layoutKey(scene.holes, true, true),
      layoutKey(scene.holes, false, false),
    ];
    expect(new Set([key, ...others]).size).toBe(4);
  });
});
