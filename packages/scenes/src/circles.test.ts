import { bodies, contacts, energy, step } from '@principia/physics';
import { expect, test } from 'vitest';
import { circles } from './circles.ts';

test.each([2, 3] as const)('bodies fill the box as said, stay in it and hardly overlap, in %iD', (dimensions) => {
  const { world, dt } = circles.create({ count: 300, dimensions, precision: 'f64' });
  const { Position, Collider } = world.components;
  const { ids, count } = bodies(world);
  const start = energy(world).total;
  for (let s = 0; s < 480; s++) {
    step(world, dt);
    // However hard they fall, no centre gets into another body.
    const { a, b, count: met } = contacts(world);
    for (let i = 0; i < met; i++) {
      const [dx, dy, dz] = (['x', 'y', 'z'] as const).map((axis) => Position[axis][a[i]] - Position[axis][b[i]]);
      const larger = Math.max(Collider.radius[a[i]], Collider.radius[b[i]]);
      if (!(Math.sqrt(dx * dx + dy * dy + dz * dz) > larger)) expect.fail(`step ${s}: ${a[i]} is in ${b[i]}`);
    }
  }
  expect(energy(world).total).toBeLessThan(start);
  let deepest = 0;
  for (let i = 0; i < count; i++) {
    const a = ids[i];
    expect(Position.x[a]).toBeGreaterThanOrEqual(0.95 * Collider.radius[a]);
    expect(Position.y[a]).toBeGreaterThanOrEqual(0.95 * Collider.radius[a]);
    for (let j = i + 1; j < count; j++) {
      const b = ids[j];
      const [dx, dy, dz] = (['x', 'y', 'z'] as const).map((axis) => Position[axis][a] - Position[axis][b]);
      const gap = Math.sqrt(dx * dx + dy * dy + dz * dz) - Collider.radius[a] - Collider.radius[b];
      deepest = Math.max(deepest, -gap);
    }
  }
  // A thousandth of the radii may stay. Where the sweeps leave a contact all the speed that one step of gravity gives to
  // every layer above it, it closes by layers g dt² a step, and the rounds that take overlaps apart leave at most half.
  const layers = dimensions === 2 ? 12 : 7;
  expect(deepest).toBeLessThan(0.001 * 0.2 + 2 * layers * 9.80665 * dt * dt);
});

test('nothing overlaps before the first step', () => {
  const { world } = circles.create({ count: 200, dimensions: 3, precision: 'f64' });
  const { Position, Collider } = world.components;
  for (let a = 1; a <= 200; a++) {
    for (let b = a + 1; b <= 200; b++) {
      const [dx, dy, dz] = (['x', 'y', 'z'] as const).map((axis) => Position[axis][a] - Position[axis][b]);
      const distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
      expect(distance).toBeGreaterThanOrEqual((Collider.radius[a] + Collider.radius[b]) * (1 - 1e-12));
    }
  }
});
