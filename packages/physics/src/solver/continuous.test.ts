// Fast bodies do not pass through bodies without mass, however thin those are, and do not sink in where they land.
import {
  box,
  createJoint,
  createPhysicsWorld,
  polygon,
  revolute,
  rigidBodies,
  segment,
  spawn,
  step,
  uniformGravity,
} from '@principia/physics';
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

const G = 9.80665;

test.each<[string, 'f32' | 'f64', object]>([
  ['ball', 'f32', { radius: 0.5 }],
  ['ball', 'f64', { radius: 0.5 }],
  ['box', 'f32', { shape: box(1, 1) }],
  ['box', 'f64', { shape: box(1, 1) }],
])('a %s that falls from 0.5 to 10 m does not sink into the ground (%s)', (_, precision, shape) => {
  for (let height = 0.5; height <= 10; height += 0.19) {
    const world = createPhysicsWorld({
      preset: rigidBodies,
      precision,
      capacity: 100,
      forces: [uniformGravity({ y: -G })],
    });
    spawn(world, { position: { y: -5 }, collider: { shape: box(40, 10) } });
    const collider = { ...shape, density: 1, restitution: 0.5 };
    const body = spawn(world, { position: { y: height + 0.5 }, collider });
    const { Position, Velocity } = world.components;
    let top = 0;
    for (let rises = false; !rises || Velocity.y[body] > 0; ) {
      step(world, DT);
      // Twice the slop: it stops within it, and a step later the soft contact gives way as much.
      expect(Position.y[body], `from ${height} m`).toBeGreaterThan(0.5 - 0.01);
      rises ||= Velocity.y[body] > 0;
      if (rises) top = Math.max(top, Position.y[body] - 0.5);
    }
    // The speed at which it bounces is known to what it gains in a step, g dt, and so its height to 2 g dt / v.
    const speed = Math.sqrt(2 * G * height);
    expect(Math.abs(top / (0.25 * height) - 1), `from ${height} m`).toBeLessThan((2 * G * DT) / speed);
  }
});

test('boxes that a hinge holds land without being torn apart, and do not sink in', () => {
  for (let height = 1; height <= 10; height += 0.37) {
    const world = createPhysicsWorld({ preset: rigidBodies, capacity: 100, forces: [uniformGravity({ y: -G })] });
    spawn(world, { position: { y: -5 }, collider: { shape: box(40, 10) } });
    const collider = { shape: box(1, 1), density: 1 };
    const lower = spawn(world, { position: { y: height + 0.5 }, collider });
    const upper = spawn(world, { position: { y: height + 1.5 }, collider });
    createJoint(world, revolute({ a: lower, b: upper, anchor: { y: height + 1 } }));
    const { Position } = world.components;
    const steps = Math.ceil((Math.sqrt((2 * height) / G) + 0.1) / DT);
    // In the sub-step in which the contact stops the lower one, the joint stops the upper one: half of it, if not at once.
    const gap = (Math.sqrt(2 * G * height) * DT) / 4 / 2;
    for (let i = 0; i < steps; i++) {
      step(world, DT);
      expect(Math.abs(Position.y[upper] - Position.y[lower] - 1), `from ${height} m`).toBeLessThan(gap);
      expect(Position.y[lower], `from ${height} m`).toBeGreaterThan(0.5 - 0.005);
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
