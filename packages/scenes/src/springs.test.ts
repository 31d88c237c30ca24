import { bodies, energy, momentum, step } from '@principia/physics';
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
  // Five full rows of six nodes, and the 50th spring on one more of a post: what posts and springs pull cancels.
  const { world, dt } = springs.create({ count: 50, speed: 0, precision: 'f64' });
  const { Position, Mass } = world.components;
  const [x, y] = [Position.x.slice(), Position.y.slice()];
  for (let i = 0; i < 50; i++) step(world, dt);
  const { ids, count } = bodies(world);
  const posts = ids.subarray(0, count).filter((id) => Mass.value[id] === 0);
  expect(posts).toHaveLength(2 * 5 + 1);
  for (const id of posts) expect(Math.hypot(Position.x[id] - x[id], Position.y[id] - y[id])).toBe(0);
  // The outer rows are drawn in; 50 springs of 1 N for 50 steps, each impulse rounded by some 2⁻⁵³ of it: 6e-16 N s.
  expect(energy(world).kinetic).toBeGreaterThan(0.01);
  expect(Math.abs(momentum(world).x)).toBeLessThan(1e-15);
  expect(Math.abs(momentum(world).y)).toBeLessThan(1e-15);
});
