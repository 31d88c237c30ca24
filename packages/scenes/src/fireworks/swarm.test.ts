import { restore, snapshot, stateHash, step } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { type Fireworks, fireworks } from '../fireworks.ts';
import { colorRamp, STAR_RGB } from './colors.ts';
import { heldStars, maxHoldSeconds, SHELL_NAMES, SHELLS } from './shells.ts';

const SWARM = SHELL_NAMES.indexOf('swarm');
const YELLOW = 2;

function night(seed: number): Fireworks {
  return fireworks.create({ count: 0, shells: 1, seed });
}

/** Lights a swarm of so many stars. */
function light(run: Fireworks, stars: number, x = 0): boolean {
  return run.launch({ x, y: 40, z: 0, kind: SWARM, color: 5, power: stars / SHELLS[SWARM].stars });
}

/** Steps until all is dark. */
function burnOut(run: Fireworks): void {
  do step(run.world, run.dt);
  while (run.alive > 0);
}

const starsOf = ({ world: { components, lastId } }: Fireworks) =>
  Array.from({ length: lastId }, (_, i) => i + 1).filter(
    (id) => Math.fround(components.Mass.value[id]) === Math.fround(0.001),
  );

describe('a swarm', () => {
  test('has two stars for each second, which a part of five seconds says exactly', () => {
    const { stars } = SHELLS[SWARM];
    expect(maxHoldSeconds(SHELLS[SWARM])).toBe(5);
    for (let seconds = 0; seconds <= 5; seconds++) expect(heldStars(SHELLS[SWARM], seconds / 5)).toBe(2 * seconds);
    expect(heldStars(SHELLS[SWARM], 1)).toBe(stars);
  });

  test.each([
    [2, 5],
    [4, 5],
    [10, 1],
  ])(
    'of %i stars bears N + N² + N³/2 in all, in the mean of eight at once, and is dark after ten seconds',
    (stars, rounds) => {
      const run = night(1);
      for (let round = 0; round < rounds; round++) {
        for (let i = 0; i < 8; i++) expect(light(run, stars, 8 * i)).toBe(true);
        const from = run.world.time;
        burnOut(run);
        expect(run.world.time - from).toBeLessThan(10 + 4 * run.dt);
      }
      // Lives are 2 to 4 s. A parent that ends at T bears N stars, each of which ends before 6 s by a chance of (4 - T)/2,
      // which is even over 0 to 1: how many of the N do is even over 0 to N, of variance N (N + 2)/12. There are N such
      // parents, and each of these stars bears N.
      const count = 8 * rounds;
      const deviation = stars * stars * Math.sqrt((stars + 2) / 12 / count);
      expect(Math.abs(run.born / count - (stars + stars ** 2 + stars ** 3 / 2))).toBeLessThan(4 * deviation);
    },
  );

  test('is not lit by less than a second, nor by less than none', () => {
    const run = night(1);
    expect(light(run, 0)).toBe(false);
    step(run.world, run.dt);
    expect([run.alive, run.flying, run.events.count]).toEqual([0, 0, 0]);
  });

  test('bears its first stars in pairs, without momentum, and yellow; the next are of any colour', () => {
    const run = night(4);
    light(run, 6);
    step(run.world, run.dt);
    const { Velocity, Position, Appearance } = run.world.components;
    const stars = starsOf(run);
    expect(stars).toHaveLength(6);
    for (const id of stars) {
      expect(Appearance.color[id]).toBe(colorRamp(STAR_RGB[YELLOW])[0]);
      expect(Math.hypot(Position.x[id], Position.y[id] - 40)).toBeLessThan(13 * run.dt);
    }
    // Pairs of opposite velocities; gravity and drag of one step make them 9.8/60 m/s less opposite.
    expect(Math.abs(stars.reduce((sum, id) => sum + Velocity.x[id], 0))).toBeLessThan(1e-3);
    while (run.born < 6 * 7) step(run.world, run.dt);
    for (let i = 0; i < 6; i++) step(run.world, run.dt);
    expect(new Set(starsOf(run).map((id) => Appearance.color[id])).size).toBeGreaterThan(3);
  });

  test('keeps its clock and its number beside others: each of two is what it is alone', () => {
    const after = (stars: number) => {
      const run = night(9);
      light(run, 4, -48);
      for (let i = 0; i < 120; i++) step(run.world, run.dt);
      if (stars > 0) light(run, stars, 48);
      // The first one's last stars are born before 6 s and end before 10 s, the second one's 2 s later.
      while (run.world.time < 10.1) step(run.world, run.dt);
      const { x } = run.world.components.Position;
      const ids = starsOf(run);
      return { left: ids.filter((id) => x[id] < 0).length, right: ids.some((id) => x[id] > 0) };
    };
    expect(after(0)).toEqual({ left: 0, right: false });
    expect(after(10)).toEqual({ left: 0, right: true });
  });

  test('more of them than there are pools give way to each other, and nothing is lost but light', () => {
    const run = night(2);
    for (let i = 0; i < 20; i++) {
      expect(light(run, 10, 4 * i - 40)).toBe(true);
      step(run.world, run.dt);
    }
    expect(run.alive).toBe(200);
    burnOut(run);
    expect(run.world.faults.faults).toEqual([]);
  });

  test('goes on alike after the world went back', () => {
    const run = night(6);
    light(run, 8);
    for (let i = 0; i < 170; i++) step(run.world, run.dt);
    const taken = snapshot(run.world);
    const after = () => {
      for (let i = 0; i < 240; i++) step(run.world, run.dt);
      return `${stateHash(run.world)} ${run.born}`;
    };
    const wanted = after();
    restore(run.world, taken);
    expect(after()).toBe(wanted);
  });
});
