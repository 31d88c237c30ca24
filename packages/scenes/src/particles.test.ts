import { energy, step } from '@principia/physics';
import { expect, test } from 'vitest';
import { particles } from './particles.ts';

test('particles stay in the box and only lose energy', () => {
  const { world, dt } = particles.create({ count: 2000, dimensions: 3, speed: 100 });
  const { Position, Collider } = world.components;
  let last = energy(world).total;
  for (let s = 0; s < 600; s++) {
    step(world, dt);
    if (s % 20 !== 0) continue;
    const now = energy(world).total;
    // Gravity of semi-implicit Euler adds m g² dt²/2 a step at most; anything more would be a wall that gives energy.
    expect(now).toBeLessThan(last * (1 + 1e-3));
    last = now;
  }
  for (let i = 1; i <= 2000; i++) {
    for (const axis of ['x', 'y', 'z'] as const) {
      expect(Position[axis][i]).toBeGreaterThanOrEqual(Collider.radius[i] * (1 - 1e-6));
      expect(Position[axis][i]).toBeLessThanOrEqual(100 - Collider.radius[i] + 1e-5);
    }
  }
});

test('a particle falls to its terminal speed', () => {
  const { world, dt } = particles.create({ count: 1, precision: 'f64', speed: 0, side: 100_000, drag: 0.5 });
  for (let s = 0; s < 1200; s++) step(world, dt);
  const { Velocity, Mass, QuadraticDrag } = world.components;
  const terminal = Math.sqrt((Mass.value[1] * 9.80665) / QuadraticDrag.coefficient[1]);
  expect(-Velocity.y[1] / terminal).toBeCloseTo(1, 6);
});
