// Gravity, orbits and rockets.
import { angularMomentum, energy, positionFirstEuler, rungeKutta4, step, velocityVerlet } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import celestialGravity from '../../packages/scenes/src/examples/ch06/celestial-gravity.ts';
import gWithHeight from '../../packages/scenes/src/examples/ch06/g-with-height.ts';
import gravityLaw from '../../packages/scenes/src/examples/ch06/gravity-law.ts';
import orbits from '../../packages/scenes/src/examples/ch06/orbits.ts';
import rocket from '../../packages/scenes/src/examples/ch06/rocket.ts';
import { forceOn, run, started } from '../support/laws.ts';

const SUN = { x: 275, y: 200 };

test('ch06-gravity-law: doubling the distance quarters the force, and action equals reaction', () => {
  // Pairs of 3 and 5 kg at 1, 2 and 4 m from each other.
  const { world } = started(gravityLaw);
  const forces = [1, 3, 5].map((eid) => [forceOn(world, eid).x, forceOn(world, eid + 1).x]);
  expect(forces[1][0]).toBe(15 / 4);
  expect(forces[2][0] / forces[1][0]).toBe(0.25);
  for (const [first, second] of forces) expect(first).toBe(-second);
});

test('ch06-orbits: angular momentum and energy over 1000 s for each scheme', () => {
  for (const [integrator, bound, momentumBound] of [
    [positionFirstEuler, 2.3e-3, 1e-13],
    [velocityVerlet, 1.3e-5, 1e-13],
    [rungeKutta4, 1.6e-10, 2e-10],
  ] as const) {
    const { world } = orbits.start({ integrator });
    const start = energy(world).total;
    let worst = 0;
    run(world, 1000, 1 / 60, () => {
      worst = Math.max(worst, Math.abs(energy(world).total / start - 1));
    });
    expect(worst, integrator.name).toBeLessThan(1.05 * bound);
    expect(Math.abs(angularMomentum(world, SUN).z / 15000 - 1)).toBeLessThan(momentumBound);
  }
});

test('ch06-g-with-height: linear inside, inverse square outside', () => {
  const { world, eid } = started(gWithHeight);
  for (const [r, g] of [
    [0.5, 4.905],
    [1, 9.81],
    [2, 2.4525],
    [10, 0.0981],
  ]) {
    world.components.Position.y[eid] = r;
    expect(-forceOn(world, eid).y).toBeCloseTo(g, 12);
  }
});

test('ch06-celestial-gravity: Moon, Mars and Jupiter; the fall goes as 1/√g', () => {
  // The third ball falls on the Earth.
  for (const [eid, g, digits] of [
    [1, 1.624, 3],
    [2, 3.728, 3],
    [4, 25.93, 2],
  ]) {
    const { world, at } = started(celestialGravity, {}, eid);
    const pull = -forceOn(world, eid).y;
    expect(pull).toBeCloseTo(g, digits);
    run(world, Math.sqrt(20 / pull));
    expect(at().y - world.components.Collider.radius[eid]).toBeCloseTo(0, 10);
  }
});

describe('ch06-rocket', () => {
  /** Id of the rocket, which stands on top of the planet; that fills r < 100 about (400, 400), and y points down. */
  const ROCKET = 2;
  const launch = (values = {}) => started(rocket, { values }, ROCKET);

  test('ch06-rocket: thrust is weight at lift-off; burn-out at 7 s, 50.87 up at 27.145; peak at r = 339.69', () => {
    const { world, eid, at, going } = launch();
    step(world, 1e-6);
    expect(going().y / 1e-6).toBeCloseTo(0, 4);
    expect(world.components.Engine.fuel[eid]).toBeCloseTo(3.5 - 0.5e-6, 12);
    run(world, 7 - 1e-6, 1 / 240);
    expect(world.components.Engine.fuel[eid]).toBeCloseTo(0, 9);
    expect((300 - at().y) / 50.87).toBeCloseTo(1, 3);
    expect(-going().y / 27.145).toBeCloseTo(1, 3);
    expect(Math.sqrt(2e5 / (400 - at().y))).toBeCloseTo(36.41, 2);
    let peak = 0;
    run(world, 60, 1 / 60, () => {
      peak = Math.max(peak, 400 - at().y);
    });
    expect(peak / 339.69).toBeCloseTo(1, 3);
  });

  test('the thrust columns hold the thrust while the engine fires, and zero afterwards', () => {
    const { world, eid } = launch();
    const { fuel, thrustX, thrustY } = world.components.Engine;
    run(world, 6.5, 1 / 64);
    expect(fuel[eid]).toBeCloseTo(0.25, 12);
    // 200 × 0.5 N along the nose, less the part of the mass that half a step burns.
    expect(thrustX[eid]).toBe(0);
    expect(-thrustY[eid] / 100).toBeCloseTo(1 - 0.5 / 64 / (2 * 6.75), 6);
    run(world, 1, 1 / 64);
    expect([fuel[eid], thrustX[eid], thrustY[eid]].map(Math.abs)).toEqual([0, 0, 0]);
  });

  test('ch06-rocket: without gravity Δv = v_e ln(10/6.5) = 86.157', () => {
    const { world, going } = launch({ gravity: 0 });
    run(world, 8);
    expect(-going().y).toBeCloseTo(86.157, 3);
    expect(-going().y / (200 * Math.log(10 / 6.5))).toBeCloseTo(1, 6);
  });
});
