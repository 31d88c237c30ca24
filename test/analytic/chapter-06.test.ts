// Gravity, orbits and rockets.
import {
  angularMomentum,
  createPhysicsWorld,
  energy,
  mutualGravity,
  positionFirstEuler,
  rungeKutta4,
  spawn,
  step,
  uniformGravity,
  uniformSphereGravity,
  velocityVerlet,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import orbits from '../../packages/scenes/src/examples/ch06/orbits.ts';
import rocket from '../../packages/scenes/src/examples/ch06/rocket.ts';
import { forceOn, lawOn, run, single, started } from '../support/laws.ts';

const SUN = { x: 275, y: 200 };

test('ch06-gravity-law: doubling the distance quarters the force, and action equals reaction', () => {
  const pull = (r: number) => {
    const world = createPhysicsWorld({ capacity: 5, forces: [mutualGravity({ G: 1 })] });
    const a = spawn(world, { position: {}, velocity: {}, mass: 3 });
    const b = spawn(world, { position: { x: r }, velocity: {}, mass: 5 });
    return [forceOn(world, a).x, forceOn(world, b).x];
  };
  expect(pull(2)[0]).toBe(15 / 4);
  expect(pull(4)[0] / pull(2)[0]).toBe(0.25);
  expect(pull(1.7)[0]).toBe(-pull(1.7)[1]);
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
  const law = uniformSphereGravity({ mu: 9.81, radius: 1 });
  for (const [r, g] of [
    [0.5, 4.905],
    [1, 9.81],
    [2, 2.4525],
    [10, 0.0981],
  ]) {
    expect(-lawOn(law, { position: { y: r } }).y).toBeCloseTo(g, 12);
  }
});

test('ch06-celestial-gravity: Moon, Mars and Jupiter; the fall goes as 1/√g', () => {
  for (const [mu, radius, g, digits] of [
    [4902.8e9, 1737.4e3, 1.624, 3],
    [42828.4e9, 3389.5e3, 3.728, 3],
    [1.26713e17, 69911e3, 25.93, 2],
  ]) {
    expect(-lawOn(uniformSphereGravity({ mu, radius }), { position: { y: radius } }).y).toBeCloseTo(g, digits);
    const { world, at } = single([uniformGravity({ y: -g })], { position: { y: 10 } });
    run(world, Math.sqrt(20 / g));
    expect(at().y).toBeCloseTo(0, 10);
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
