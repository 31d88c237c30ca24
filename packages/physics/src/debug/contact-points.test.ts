import { box, contactPoints, createPhysicsWorld, rigidBodies, spawn, step, uniformGravity } from '@principia/physics';
import { expect, it } from 'vitest';

it.each(['f32', 'f64'] as const)('the contact points of a resting box carry its weight, %s', (precision) => {
  const [g, dt] = [10, 1 / 60];
  const world = createPhysicsWorld({
    preset: rigidBodies,
    forces: [uniformGravity({ y: -g })],
    capacity: 100,
    precision,
  });
  const floor = spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1), friction: 0.6 } });
  const body = spawn(world, {
    position: { x: 3, y: 0.5 },
    collider: { shape: box(1, 1), density: 2, friction: 0.6 },
  });
  const list = contactPoints(world);
  expect(list.count).toBe(0);
  for (let i = 0; i < 60; i++) step(world, dt);
  expect(contactPoints(world, list)).toBe(list);
  expect(list.count).toBe(2);
  const [left, right] = list.x.slice(0, 2).sort((p, q) => p - q);
  expect([left, right]).toEqual([expect.closeTo(2.5, 3), expect.closeTo(3.5, 3)]);
  expect([list.a[0], list.b[0], list.nx[0], list.ny[0]]).toEqual([floor, body, expect.closeTo(0, 5), 1]);
  expect(Math.abs(list.y[0])).toBeLessThan(0.005);
  // Two contacts together: m g dt.
  expect((list.impulse[0] + list.impulse[1]) / (2 * g * dt)).toBeCloseTo(1, 3);
});
