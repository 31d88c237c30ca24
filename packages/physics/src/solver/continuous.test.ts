// Fast bodies do not pass through bodies without mass, however thin those are.
import { box, createPhysicsWorld, polygon, rigidBodies, segment, spawn, step } from '@principia/physics';
import { expect, test } from 'vitest';

const DT = 1 / 60;
const ROUND = [{ shape: undefined, radius: 0.1 }, 'a disc'] as const;
const BOX = [{ shape: box(0.2, 0.2), radius: undefined }, 'a box'] as const;
const TRIANGLE = [{ shape: polygon([{}, { x: 0.3 }, { y: 0.3 }]), radius: undefined }, 'a triangle'] as const;

test.each([ROUND, BOX, TRIANGLE])('a body of 400 m/s stays in front of a line', ({ shape, radius }) => {
  for (const precision of ['f32', 'f64'] as const) {
    const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 100 });
    spawn(world, {
      collider: { shape: segment({ x: 10, y: -20 }, { x: 10, y: 20 }), friction: 0.5 },
      position: { x: 10 },
    });
    // They pass through each other.
    const filter = { density: 1, layers: 2, mask: 1 };
    const collider = shape === undefined ? { radius, ...filter } : { shape, ...filter };
    const bodies = Array.from({ length: 20 }, (_, i) => {
      const velocity = { x: 400 - 7 * i, y: 3 * i };
      return spawn(world, { position: { x: 0.37 * i, y: 0.5 * i - 5 }, velocity, angularVelocity: i, collider });
    });
    for (let i = 0; i < 60; i++) {
      step(world, DT);
      for (const body of bodies) expect(world.components.Position.x[body]).toBeLessThan(10);
    }
  }
});

test('a fast body slides along the ground that it lies on', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 100 });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(1000, 1) } });
  const body = spawn(world, {
    position: { y: 0.1 },
    velocity: { x: 100 },
    collider: { shape: box(0.2, 0.2), density: 1 },
  });
  for (let i = 0; i < 60; i++) step(world, DT);
  // Without friction nothing slows it down.
  expect(world.components.Position.x[body] / 100).toBeCloseTo(1, 2);
});
