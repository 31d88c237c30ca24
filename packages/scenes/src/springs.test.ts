import { energy, momentum, step } from '@principia/physics';
import { expect, test } from 'vitest';
import { springs } from './springs.ts';

test('makes exactly as many springs as asked for, between bodies', () => {
  for (const count of [1, 2, 3, 10, 999]) {
    const { world } = springs.create({ count });
    const { Spring } = world.components;
    const ends = Array.from(Spring.a).filter((a) => a > 0);
    expect(ends).toHaveLength(count);
  }
});

test('a net keeps its energy, and loses it when damped', () => {
  const total = (damping: number, steps: number) => {
    const { world, dt } = springs.create({ count: 1000, dimensions: 3, damping, precision: 'f64' });
    const start = energy(world);
    expect(start.potential).toBeGreaterThan(0);
    for (let s = 0; s < steps; s++) step(world, dt);
    return (energy(world).total - start.total) / start.kinetic;
  };
  expect(Math.abs(total(0, 2000))).toBeLessThan(0.04);
  expect(total(0.05, 500)).toBeLessThan(-0.1);
});

test('posts do not move and springs pull equally both ways', () => {
  const { world, dt } = springs.create({ count: 50, speed: 0, precision: 'f64' });
  const before = world.components.Position.x.slice();
  step(world, dt);
  const { Position, Mass } = world.components;
  for (let i = 1; i < 20; i++) if (Mass.value[i] === 0) expect(Position.x[i]).toBe(before[i]);
  expect(Math.abs(momentum(world).x)).toBeLessThan(1);
});
