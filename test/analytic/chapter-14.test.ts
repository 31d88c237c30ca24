// Numerical integration: each scheme on the same few problems.
import {
  bodies,
  energy,
  explicitEuler,
  heun,
  type Integrator,
  implicitEuler,
  positionFirstEuler,
  rungeKutta4,
  semiImplicitEuler,
  step,
  velocityVerlet,
} from '@principia/physics';
import type { Example } from '@principia/scenes/examples';
import { describe, expect, test } from 'vitest';
import implicitEulerExample from '../../packages/scenes/src/examples/ch14/implicit-euler.ts';
import orbits from '../../packages/scenes/src/examples/ch14/orbits.ts';
import projectileVerlet from '../../packages/scenes/src/examples/ch14/projectile-verlet.ts';
import ropeEuler from '../../packages/scenes/src/examples/ch14/rope-euler.ts';
import schemesProjectileDrag from '../../packages/scenes/src/examples/ch14/schemes-projectile-drag.ts';
import semiImplicitEulerExample from '../../packages/scenes/src/examples/ch14/semi-implicit-euler.ts';
import timestepTips from '../../packages/scenes/src/examples/ch14/timestep-tips.ts';
import { orders } from '../support/integrator-problems.ts';
import { run, started } from '../support/laws.ts';
import { measureOrbit } from '../support/orbits.ts';

const DT = 1 / 60;

/** Returns the distance from the exact position of a projectile with drag after 10 s. */
function projectileError(integrator: Integrator, steps = 600): number {
  const { world, at } = started(schemesProjectileDrag, { integrator });
  for (let i = 0; i < steps; i++) step(world, 10 / steps);
  const fade = 1 - Math.exp(-1);
  return Math.hypot(at().x - (50 + 600 * fade), at().y - (400 + 1000 - 1600 * fade));
}

test('ch14-schemes-projectile-drag: errors after 10 s, and the order of each scheme', () => {
  expect(projectileError(explicitEuler)).toBeCloseTo(0.524, 3);
  expect(projectileError(semiImplicitEuler)).toBeCloseTo(1.28, 2);
  expect(projectileError(heun)).toBeCloseTo(2.9e-4, 5);
  expect(projectileError(rungeKutta4)).toBeLessThan(1e-10);
  // Ours predicts the velocity at the end of the step, so that drag costs it no order.
  expect(projectileError(velocityVerlet)).toBeLessThan(1e-3);
  for (const [integrator, order, steps] of [
    [explicitEuler, 1, 600],
    [semiImplicitEuler, 1, 600],
    [velocityVerlet, 2, 600],
    [heun, 2, 600],
    [rungeKutta4, 4, 50],
  ] as const) {
    for (const measured of orders((n) => projectileError(integrator, n), steps)) {
      expect(Math.abs(measured - order), integrator.name).toBeLessThan(0.1);
    }
  }
});

/** Steps the oscillator of ω = 1 that starts 200 from its centre at rest. @param rate steps per second */
function oscillate(
  example: Example,
  { rate, steps, integrator }: { rate: number; steps: number; integrator?: Integrator },
  each?: (x: number, v: number) => void,
) {
  const { world, eid } = started(example, {
    values: { rate },
    ...(integrator === undefined ? {} : { integrator }),
  });
  const [{ x }, v] = [world.components.Position, world.components.Velocity];
  for (let i = 0; i < steps; i++) {
    step(world, 1 / rate);
    each?.(x[eid], v.x[eid]);
  }
  return { world, x: x[eid], amplitude: Math.hypot(x[eid], v.x[eid]) };
}

test('ch14-implicit-euler: the amplitude shrinks by √(1 + ω² dt²) a step, and a step of 10 s is stable', () => {
  const { amplitude, world } = oscillate(implicitEulerExample, { rate: 60, steps: 6000 });
  expect(amplitude).toBeCloseTo(86.93, 3);
  expect(amplitude).toBeCloseTo(200 / (1 + DT * DT) ** 3000, 5);
  expect(world.faults.faults).toEqual([]);
  const long = oscillate(implicitEulerExample, { rate: 0.1, steps: 5 });
  expect(long.amplitude).toBeCloseTo(200 / Math.sqrt(101) ** 5, 6);
  expect(long.world.faults.faults).toEqual([]);
});

test('ch14-semi-implicit-euler: both orderings stay bounded, with an energy error of ω dt/2', () => {
  for (const integrator of [semiImplicitEuler, positionFirstEuler]) {
    let worst = 0;
    let last = 0;
    oscillate(semiImplicitEulerExample, { rate: 60, steps: 1_000_000, integrator }, (x, v) => {
      last = Math.abs((x * x + v * v) / 40_000 - 1);
      worst = Math.max(worst, last);
    });
    expect(worst).toBeLessThan((1.02 * DT) / 2);
    expect(worst).toBeGreaterThan((0.98 * DT) / 2);
    const errors = [60, 120, 240].map((n) => {
      const { x } = oscillate(semiImplicitEulerExample, { rate: n, steps: n, integrator });
      return Math.abs(x + 200 * Math.cos(1));
    });
    for (const [i, wanted] of [1.4, 0.702, 0.351].entries()) expect(errors[i]).toBeCloseTo(wanted, 2);
  }
});

/** The planet of a = 228.571 and e = 0.125, at its periapsis. */
function planet(integrator: Integrator) {
  return started(orbits, { integrator }, 2);
}

/** Lowest, highest and last error of the energy over 200 s, in parts of what it was. */
function energyErrors(integrator: Integrator) {
  const { world } = planet(integrator);
  const start = energy(world).total;
  let [low, high, last] = [0, 0, 0];
  for (let i = 0; i < 12_000; i++) {
    step(world, DT);
    last = (energy(world).total - start) / Math.abs(start);
    low = Math.min(low, last);
    high = Math.max(high, last);
  }
  return { low, high, last };
}

describe('ch14-orbits', () => {
  test('ch14-orbits: a = 228.571, e = 0.125, T = 21.7126, apoapsis 257.143', () => {
    const { world, eid } = planet(rungeKutta4);
    expect(-1e6 / (2 * energy(world).total)).toBeCloseTo(228.571, 3);
    const { near, far, period } = measureOrbit(world, eid, { x: 400, y: 300 }, 60, DT);
    // Half a unit of the last digits; the extremes between steps are those of a parabola, to (ω dt)⁴.
    expect(Math.abs(far - 257.143)).toBeLessThan(5e-4);
    expect(Math.abs((far - near) / (far + near) - 0.125)).toBeLessThan(1e-6);
    expect(Math.abs(period - 21.7126)).toBeLessThan(1e-4);
  });

  test.each([
    ['explicit Euler spirals out by 0.287', explicitEuler, 0.287, 3],
    ['velocity Verlet errs by at most 3.2e-6', velocityVerlet, 3.2e-6, 7],
    ['Heun errs, more and more, by 1.3e-5', heun, 1.3e-5, 6],
    ['Runge-Kutta 4 loses 1.1e-11', rungeKutta4, -1.1e-11, 12],
  ] as const)('ch14-orbits: energy over 200 s: %s', (_, integrator, figure, digits) => {
    const { low, high, last } = energyErrors(integrator);
    // What grows is taken at the end, what swings where it is largest, both to half a unit of the figure's last digit.
    const measured = figure < 0 ? last : Math.max(high, -low);
    expect(Math.abs(measured - figure)).toBeLessThan(0.5 * 10 ** -digits);
  });

  test('ch14-orbits: the energy of semi-implicit Euler stays within ±6.7e-4, which is v·a dt/2', () => {
    // The scheme conserves E ∓ v·a dt/2 to the next order: the largest v·a = -μ r'/r² on the ellipse, of |E| = μ/2a.
    const [a, e] = [1600 / 7, 0.125];
    const p = a * (1 - e * e);
    const along = Array.from({ length: 10_000 }, (_, i) => (i * Math.PI) / 10_000);
    const power = along.map((ν) => (Math.sqrt(1e6 / p) * e * Math.sin(ν) * 1e6 * (1 + e * Math.cos(ν)) ** 2) / p ** 2);
    const swing = (Math.max(...power) * DT) / 2 / (1e6 / (2 * a));
    for (const integrator of [positionFirstEuler, semiImplicitEuler]) {
      const { low, high } = energyErrors(integrator);
      expect(Math.max(high, -low)).toBeLessThan(6.7e-4);
      // Terms of odd order remain in the difference, the next some ten times (ω dt)² = 3.5e-5 of the periapsis.
      expect(Math.abs((high - low) / 2 / swing - 1)).toBeLessThan(1e-3);
    }
  });
});

test('ch14-projectile-verlet: the exact parabola, and the error without half a step of gravity at the start', () => {
  const { world, eid: ball } = started(projectileVerlet);
  const { Position } = world.components;
  let worst = 0;
  for (let i = 1; i <= 1000; i++) {
    step(world, 0.02);
    const t = i * 0.02;
    worst = Math.max(worst, Math.hypot(Position.x[ball] - 50 - 30 * t, Position.y[ball] - 550 + 100 * t - 5 * t * t));
    if (i === 500) expect([Position.x[ball], Position.y[ball]].map(Math.round)).toEqual([350, 50]);
  }
  expect([Position.x[ball], Position.y[ball]].map(Math.round)).toEqual([650, 550]);
  expect(worst).toBeLessThan(1e-8);
  // With the last place taken as x - v dt the same ball would be a whole metre off after 10 s.
  let [before, now] = [550 + 100 * 0.02, 550];
  for (let i = 0; i < 500; i++) [before, now] = [now, 2 * now - before + 10 * 0.02 ** 2];
  expect(now - 50).toBeCloseTo((10 * 0.02 * 10) / 2, 8);
});

/** Largest speed in the rope after a time, and where its middle is. */
function rope(integrator: Integrator, dt: number, time = 60) {
  const { world } = ropeEuler.start({ integrator });
  const { ids, count } = bodies(world);
  for (let i = 0; i < time / dt; i++) step(world, dt);
  const { Position, Velocity } = world.components;
  const fastest = Math.max(...Array.from(ids.subarray(0, count), (id) => Math.hypot(Velocity.x[id], Velocity.y[id])));
  return { fastest, faults: world.faults.faults.length, x: Position.x[ids[8]], y: Position.y[ids[8]] };
}

test('ch14-rope-euler: explicit Euler is stable below dt = c/k, semi-implicit far beyond, implicit everywhere', () => {
  expect(rope(explicitEuler, 0.038, 600).fastest).toBeLessThan(1e-3);
  expect(rope(explicitEuler, 0.05).fastest).toBeGreaterThan(20);
  expect(rope(explicitEuler, 0.1, 4).fastest).toBeGreaterThan(100);
  expect(rope(semiImplicitEuler, 0.1, 600).fastest).toBeLessThan(1e-3);
  expect(rope(semiImplicitEuler, 0.15).faults).toBeGreaterThan(0);
  const { fastest, x, y } = rope(implicitEuler(), 0.15, 300);
  expect(fastest).toBeLessThan(1e-3);
  expect(x).toBeCloseTo(260.9, 1);
  expect(y).toBeCloseTo(159.757, 1);
});

test('ch14-timestep-tips: an apex after a bounce is off by less than g dt², because the impact is found in the step', () => {
  for (const rate of [50, 100, 200]) {
    const { world, at, going } = started(timestepTips, { values: { rate } });
    let apex = 0;
    run(world, 0.9, 1 / rate, () => {
      if (going().y > 0 || apex > 0) apex = Math.max(apex, at().y);
    });
    expect(Math.abs(apex - 0.1 - 0.64)).toBeLessThan(10 / rate ** 2);
  }
});
