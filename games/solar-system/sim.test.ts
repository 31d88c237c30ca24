import { angularMomentum, energy, restore, snapshot, step } from '@principia/physics';
import { EPOCH_2012, SOLAR_STATES } from '@principia/scenes';
import { describe, expect, test } from 'vitest';
import { julianDate } from './dates.ts';
import { burnAxes, indexOf } from './flight.ts';
import { MISSIONS } from './missions.ts';
import { createGame, type Opening, type SolarGame } from './sim.ts';
import { DAY, YEAR } from './solar-clock.ts';
import { difference, dot, lengthOf, vector } from './vectors.ts';

const opening: Opening = { date: EPOCH_2012, rate: 5 * DAY, mission: '', burns: [] };

function open(changes: Partial<Opening> = {}, moon = true): SolarGame {
  return createGame({ values: { moon }, opening: { ...opening, ...changes } });
}

function steps({ world, dt }: SolarGame, count: number): void {
  for (let i = 0; i < count; i++) step(world, dt);
}

function arrive(game: SolarGame): void {
  for (let i = 0; game.clock.isTravelling && i < 1000; i++) step(game.world, game.dt);
}

describe('the planets', () => {
  test('are within a kilometre of JPL’s positions after 366 days, the Moon within 40', () => {
    const game = open({ rate: 2 * YEAR });
    steps(game, 1);
    while (game.clock.julianDate < EPOCH_2012 + 366) steps(game, 1);
    for (const name of ['mercury', 'venus', 'earth', 'mars'] as const) {
      expect(game.errorDates[indexOf(name)]).toBe(EPOCH_2012 + 366);
      expect(game.errors[indexOf(name)], name).toBeLessThan(1);
    }
    expect(game.errors[indexOf('moon')]).toBeLessThan(40);
  });

  test('keep energy and angular momentum over ten years', () => {
    const game = open({ rate: 2 * YEAR });
    steps(game, 1);
    const [before, spin] = [energy(game.world).total, angularMomentum(game.world)];
    steps(game, 300);
    expect(game.clock.julianDate).toBeGreaterThan(EPOCH_2012 + 3000);
    // The post-Newtonian term is no part of the energy: Mercury's varies by GM/(c² r), 2.5e-8 of itself, along its orbit.
    expect(Math.abs(energy(game.world).total / before - 1)).toBeLessThan(1e-9);
    expect(Math.abs(angularMomentum(game.world).z / spin.z - 1)).toBeLessThan(1e-9);
  });

  test('go to an earlier date and back, and are where they were', () => {
    const game = open({ date: julianDate(1999, 1, 1) });
    arrive(game);
    expect(game.clock.julianDate).toBe(julianDate(1999, 1, 1));
    game.travelTo(julianDate(2001, 1, 1) + 0.25);
    arrive(game);
    // The journey passed JPL's positions of 2000-01-02 and of 365.25 days after the state.
    expect(game.errors[indexOf('earth')]).toBeLessThan(1);
    expect(game.errors[indexOf('neptune')]).toBeLessThan(1);
  });
});

describe('time', () => {
  test('runs as fast as asked for, and says what limits it', () => {
    const game = open({ rate: DAY });
    steps(game, 61);
    expect((game.clock.julianDate - EPOCH_2012) * DAY).toBeCloseTo(DAY, 0);
    expect(game.clock.limit).toBe('none');
    game.clock.rate = 100 * YEAR;
    steps(game, 1);
    expect(game.clock.limit).toBe('moon');
    expect(game.clock.actualRate / YEAR).toBeCloseTo(1.97, 1);
  });

  test('reaches 100 years a second without the Moon', () => {
    const game = open({ rate: 100 * YEAR }, false);
    steps(game, 61);
    expect(game.clock.limit).toBe('none');
    expect((game.clock.julianDate - EPOCH_2012) / 365.25).toBeCloseTo(100, 0);
    // The Earth is still between perihelion and aphelion.
    const distance = lengthOf(difference(game.bodyState('earth').position, game.bodyState('sun').position));
    expect(distance).toBeGreaterThan(1.46e8);
    expect(distance).toBeLessThan(1.53e8);
  });
});

describe('a probe', () => {
  const mission = MISSIONS[0];

  test('waits at the mission’s date, and its burn has the size that it was given', () => {
    const game = open({ mission: mission.id });
    arrive(game);
    expect(game.clock.julianDate).toBe(mission.start);
    const before = game.probeState();
    const [forward] = burnAxes(before, game.bodyState('sun'));
    expect(game.burn(3, 0, 0)).toBe(true);
    expect(dot(difference(game.probeState().velocity, before.velocity), forward)).toBeCloseTo(3, 12);
    expect(game.flight).toMatchObject({ phase: 'flying', deltaV: 3 });
    expect(game.burn(4, 0, 0)).toBe(false);
    expect(game.flight.burns).toHaveLength(1);
  });

  test('is turned by a swing-by as the hyperbola says, and gains 2 v sin(δ/2)', () => {
    const game = open({ mission: 'saturn' });
    arrive(game);
    game.burn(1, 0, 0);
    // Set before Jupiter, where the tide of the Sun is 1e-4 of what Jupiter does to the probe.
    const jupiter = game.bodyState('jupiter');
    const { Position, Velocity } = game.world.components;
    const { probe } = game.flight;
    const offset = vector(-8e6, 1e6, 0);
    for (const axis of ['x', 'y', 'z'] as const) {
      Position[axis][probe] = jupiter.position[axis] + offset[axis];
      Velocity[axis][probe] = jupiter.velocity[axis];
    }
    Velocity.x[probe] += 9;
    const relative = () => difference(game.probeState().velocity, game.bodyState('jupiter').velocity);
    const separation = () => difference(game.probeState().position, game.bodyState('jupiter').position);
    const start = relative();
    game.clock.rate = 10 * DAY;
    do steps(game, 1);
    while (lengthOf(separation()) < 8e6 || dot(relative(), separation()) < 0);
    const end = relative();
    // The hyperbola with this speed and nearest distance: v = (μ/h) (−sin ν, e + cos ν) at the true anomaly ν.
    const mu = SOLAR_STATES.jupiter.gm;
    const nearest = game.flight.closest[indexOf('jupiter')];
    const excess = Math.sqrt(dot(start, start) - (2 * mu) / lengthOf(offset));
    const e = 1 + (nearest * excess * excess) / mu;
    const bend = (distance: number) => {
      const cosine = ((nearest * (1 + e)) / distance - 1) / e;
      return Math.atan2(Math.sqrt(1 - cosine * cosine), e + cosine);
    };
    const turn = bend(lengthOf(offset)) + bend(lengthOf(separation()));
    const turned = Math.acos(dot(start, end) / (lengthOf(start) * lengthOf(end)));
    expect(nearest).toBeGreaterThan(2e5);
    expect(nearest).toBeLessThan(4e5);
    expect(turned).toBeCloseTo(turn, 3);
    // Without the tide the speed relative to Jupiter depends on the distance alone.
    const speed = Math.sqrt(excess * excess + (2 * mu) / lengthOf(separation()));
    expect(lengthOf(end) / speed).toBeCloseTo(1, 3);
    // What the swing-by gives: 2 v sin(δ/2) if both ends were equally fast.
    const mean = Math.sqrt(lengthOf(start) * lengthOf(end));
    expect(lengthOf(difference(end, start)) / (2 * mean * Math.sin(turn / 2))).toBeCloseTo(1, 3);
  });
});

test('every mission is an attempt, also one that begins after a rewind to before the last', () => {
  const game = open();
  steps(game, 2);
  const before = snapshot(game.world);
  expect(game.missionsBegun).toBe(0);
  game.startMission(MISSIONS[0]);
  restore(game.world, before);
  expect(game.missionsBegun).toBe(1);
  game.startMission(MISSIONS[0]);
  expect(game.missionsBegun).toBe(2);
});
