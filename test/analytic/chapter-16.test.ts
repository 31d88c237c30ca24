/** Chapter 16: the aeroplane of the flight simulator. Its steady flight has the figures of the book's program. */
import { step } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import flight from '../../packages/scenes/src/examples/ch16/flight-simulator.ts';
import {
  DAMPING,
  DEGREE,
  headingAndPitch,
  levelFlight,
  steadyFlight,
} from '../../packages/scenes/src/examples/support/aeroplane.ts';
import { velocityOf } from '../../packages/scenes/src/examples/support/read.ts';
import { orientationOf, point, rotate } from '../../packages/scenes/src/examples/support/space.ts';

/** Flies for some seconds with constant deflections. The aeroplane is the only body. */
function fly(values: Readonly<Record<string, number>>, seconds: number) {
  const { world, dt } = flight.start({ values });
  for (let i = 0; i < seconds / dt; i++) step(world, dt);
  const velocity = velocityOf(world, 1);
  return { velocity, ...headingAndPitch(rotate(orientationOf(world, 1), point(1, 0, 0))), world };
}

describe('ch16-flight-simulator', () => {
  test.each([
    [300, 86.404, 5.314],
    [400, 99.371, 8.493],
    [500, 111.102, 11.149],
    [200, 71.997, 1.324],
    [0, 51.203, -21.335],
  ])('in steady flight with %d kN it makes %d m/s and climbs %d m/s', (kilonewtons, forwards, climb) => {
    const steady = steadyFlight(1000 * kilonewtons);
    expect(steady.forwards).toBeCloseTo(forwards, 3);
    expect(steady.climb).toBeCloseTo(climb, 3);
  });

  test('flies exactly level with 171.887 kN at 67.703 m/s', () => {
    expect(levelFlight().thrust).toBeCloseTo(171_887, 0);
    expect(levelFlight().speed).toBeCloseTo(67.703, 3);
  });

  test('a raised elevator raises the climb and turns nothing', () => {
    const { velocity } = fly({ elevator: 1, start: 86 }, 10);
    expect(velocity.y).toBeGreaterThan(steadyFlight(300_000).climb + 1);
    expect(velocity.z).toBeCloseTo(0, 9);
  });

  test('1° of elevator at 86 m/s pitches by τ/(I k) = 0.17° a second', () => {
    const { world } = fly({ elevator: 1, start: 86.404 }, 0.5);
    const { z } = world.components.AngularVelocity;
    // C_L = 5 per radian on 10 m² at 35 m; a half-step of rotation is damped after the force is evaluated.
    const { x, y } = world.components.Velocity;
    const torque = (35 * 10 * 5 * DEGREE * (x[1] * x[1] + y[1] * y[1])) / 2;
    expect(z[1] / (torque / 160_000 / DAMPING)).toBeCloseTo(1, 2);
    expect(z[1] / DEGREE).toBeCloseTo(0.17, 2);
  });

  test('ailerons to the left bank it and turn its path to the left', () => {
    const { velocity } = fly({ aileron: 0.5, start: 86 }, 8);
    // Forwards is +x and up is +y, so left is -z.
    expect(velocity.z).toBeLessThan(-1);
  });
});
