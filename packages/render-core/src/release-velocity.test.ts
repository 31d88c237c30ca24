import { expect, it } from 'vitest';
import { ReleaseVelocity } from './release-velocity.ts';

it('is the mean velocity of the last 80 ms', () => {
  const velocity = new ReleaseVelocity();
  for (let i = 0; i < 100; i++) {
    const t = i / 100;
    velocity.add(t, t < 0.9 ? 0 : (t - 0.9) * 5, -2 * t);
  }
  velocity.estimate(0.99);
  expect(velocity.x).toBeCloseTo(5, 6);
  expect(velocity.y).toBeCloseTo(-2, 6);
});

it('is zero for a pointer that rested, a single sample, and after a reset', () => {
  const velocity = new ReleaseVelocity();
  velocity.add(0, 0, 0);
  velocity.estimate(0);
  expect([velocity.x, velocity.y]).toEqual([0, 0]);
  velocity.add(0.01, 1, 1);
  velocity.estimate(0.5);
  expect([velocity.x, velocity.y]).toEqual([0, 0]);
  velocity.estimate(0.02);
  expect(velocity.x).toBeCloseTo(100, 6);
  velocity.reset();
  velocity.estimate(0.02);
  expect(velocity.x).toBe(0);
});

it.each([0.033, 0.058, 0.1])(
  'measures a throw whose samples come every %d s, wherever in a frame it ends',
  (interval) => {
    for (let end = 0; end < 10; end++) {
      const velocity = new ReleaseVelocity();
      for (let i = 0; i < 12; i++) velocity.add(i * interval, 3 * i * interval, 0);
      velocity.estimate((11 + end / 10) * interval);
      expect(velocity.x).toBeCloseTo(3, 9);
    }
  },
);
