import {
  accelerationField,
  boris,
  createPhysicsWorld,
  dormandPrince,
  gaussRadau,
  INTEGRATORS,
  type IntegratorName,
  spawn,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import {
  advance,
  distance,
  kepler,
  keplerExact,
  orders,
  oscillator,
  oscillatorExact,
  stateOf,
} from '../../../../test/support/integrator-problems.ts';

/** With this tolerance, integrators with adaptive sub-steps take the whole step of the world. */
const create = (name: IntegratorName) =>
  name === 'dormandPrince' ? dormandPrince({ tolerance: 1e9 }) : INTEGRATORS[name].create();

/**
 * The error of order 15 is below rounding from the first step on, and Wisdom-Holman applies only to planets, so these two
 * have separate tests.
 */
const names = (Object.keys(INTEGRATORS) as IntegratorName[]).filter(
  (name) => name !== 'gaussRadau' && name !== 'wisdomHolman',
);

/** Enough steps for the asymptotic regime, few enough to stay above rounding. */
const STEPS: Record<number, number> = { 1: 1600, 2: 160, 4: 80, 5: 10, 6: 20 };

describe('order of convergence', () => {
  for (const name of names.filter((candidate) => candidate !== 'dormandPrince')) {
    const { order } = INTEGRATORS[name];
    test(`${name}, an orbit: ${order}`, () => {
      const error = (steps: number) => {
        const planet = kepler(create(name), 0.3);
        advance(planet, 2, steps);
        return distance(stateOf(planet), keplerExact(0.3, 2));
      };
      for (const measured of orders(error, STEPS[order])) expect(Math.abs(measured - order)).toBeLessThan(0.1);
    });
  }

  for (const name of names) {
    const { orderWithVelocity: order } = INTEGRATORS[name];
    test(`${name}, a damped oscillator: ${order}`, () => {
      const error = (steps: number) => {
        const ball = oscillator(create(name), 1, 0.2);
        advance(ball, 1.5, steps);
        return distance(stateOf(ball), oscillatorExact(1, 0.2, 1.5));
      };
      for (const measured of orders(error, STEPS[order])) expect(Math.abs(measured - order)).toBeLessThan(0.1);
    });
  }

  test('dormandPrince, an oscillator: 5', () => {
    const error = (steps: number) => {
      const ball = oscillator(create('dormandPrince'), 1, 0);
      advance(ball, 3, steps);
      return distance(stateOf(ball), oscillatorExact(1, 0, 3));
    };
    for (const measured of orders(error, 10)) expect(Math.abs(measured - 5)).toBeLessThan(0.1);
  });

  test('gaussRadau, an oscillator in steps of 2.0 and 1.5 rad: above 15, then rounding', () => {
    const error = (steps: number) => {
      const ball = oscillator(gaussRadau({ tolerance: 1e9 }), 1, 0);
      advance(ball, 12, steps);
      return distance(stateOf(ball), oscillatorExact(1, 0, 12));
    };
    const slope = Math.log(error(6) / error(8)) / Math.log(8 / 6);
    expect(slope).toBeGreaterThan(15);
    expect(slope).toBeLessThan(18.5);
    expect(error(12)).toBeLessThan(2e-15);
  });

  test('gaussRadau, a force of time: 15', () => {
    // The integral of Legendre's polynomial of degree 15 over [0, 1] is zero. A scheme of order 15 integrates polynomials
    // of lower degree exactly, so its error is proportional to the fifteenth power of the step from the first step on.
    // The 3 keeps the force at the start of a step, which scales the error estimate, from being zero.
    const legendre = (t: number) => {
      let [before, here] = [1, 2 * t - 1];
      for (let n = 1; n < 15; n++) [before, here] = [here, ((2 * n + 1) * (2 * t - 1) * here - n * before) / (n + 1)];
      return here;
    };
    const push = accelerationField((_x, _y, _z, t, out) => {
      out.x = 3 + legendre(t);
    });
    const error = (steps: number) => {
      const world = createPhysicsWorld({ capacity: 2, integrator: gaussRadau({ tolerance: 1e9 }), forces: [push] });
      const body = spawn(world, { position: {}, velocity: {}, mass: 1 });
      advance({ world, body }, 1, steps);
      return Math.abs(world.components.Velocity.x[body] - 3);
    };
    for (const measured of orders(error, 1)) expect(Math.abs(measured - 15)).toBeLessThan(0.1);
  });

  test('boris, charges in crossed fields: 2', () => {
    const error = (steps: number) => {
      const ball = oscillator(boris({ field: { z: 2 } }), 1, 0, { dimensions: 3 });
      ball.world.components.Charge.value[ball.body] = 1;
      advance(ball, 2, steps);
      return stateOf(ball);
    };
    const reference = error(40_000);
    for (const measured of orders((steps) => distance(error(steps), reference), 100)) {
      expect(Math.abs(measured - 2)).toBeLessThan(0.1);
    }
  });
});
