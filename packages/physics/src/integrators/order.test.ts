import { boris, dormandPrince, gaussRadau, INTEGRATORS, type IntegratorName } from '@principia/physics';
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
} from '../../../../test/support/integrator-problems';

/** Those that choose their own steps take the world's whole with a tolerance this wide. */
const create = (name: IntegratorName) =>
  name === 'dormandPrince' ? dormandPrince({ tolerance: 1e9 }) : INTEGRATORS[name].create();

/** Of the fifteenth order nothing is left between the first step and rounding; of planets there is a test of its own. */
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
