import { describe, expect, test } from 'vitest';
import {
  type BodyInput,
  contacts,
  createPhysicsWorld,
  type PhysicsWorld,
  particleContacts,
  spawn,
  step,
  uniformGravity,
} from '../index.ts';

// Powers of two, so that the surfaces meet at the end of a step to the last bit.
const DT = 1 / 64;
const RADIUS = 0.25;

const run = (world: PhysicsWorld, steps: number) => {
  for (let i = 0; i < steps; i++) step(world, DT);
};

describe.each([
  [2, 'f64'],
  [2, 'f32'],
  [3, 'f64'],
  [3, 'f32'],
] as const)('surfaces that meet at the end of a step, %d D, %s', (dimensions, precision) => {
  const worldOf = (gravity = 0) =>
    createPhysicsWorld({
      preset: particleContacts,
      dimensions,
      precision,
      ...(gravity === 0 ? {} : { forces: [uniformGravity({ x: gravity })] }),
    });
  const ball = (world: PhysicsWorld, x: number, v: number, restitution: number, more: BodyInput = {}) =>
    spawn(world, { position: { x }, velocity: { x: v }, mass: 1, collider: { radius: RADIUS, restitution }, ...more });

  test.each([0, 0.25, 0.75, 1])('rebound with the restitution %d, once', (e) => {
    const world = worldOf();
    const a = ball(world, 0, 4, e);
    const b = ball(world, 1, 0, 0);
    run(world, 8);
    const { Position, Velocity } = world.components;
    expect(Position.x[a]).toBe(0.5);
    expect(contacts(world).count).toBe(1);
    expect(contacts(world).impulse[0]).toBe(2 * (1 + e));
    expect(contacts(world).speed[0]).toBe(4);
    expect([Velocity.x[a], Velocity.x[b]]).toEqual([2 * (1 - e), 2 * (1 + e)]);
    run(world, 8);
    expect([Velocity.x[a], Velocity.x[b]]).toEqual([2 * (1 - e), 2 * (1 + e)]);
    expect(Position.x[b] - Position.x[a]).toBe(2 * RADIUS + (4 * e) / 8);
  });

  test('rebound from a body without mass', () => {
    const world = worldOf();
    const a = ball(world, 0, 4, 0.75);
    spawn(world, { position: { x: 1 }, collider: { radius: RADIUS } });
    run(world, 8);
    expect(world.components.Velocity.x[a]).toBe(-3);
    run(world, 8);
    expect(world.components.Position.x[a]).toBe(0.5 - 3 / 8);
  });

  // After eight steps from rest a = 64 m/s² has led over 1/2 m, at 8 m/s.
  test('rebound under an acceleration', () => {
    const world = worldOf(64);
    const a = ball(world, 0, 0, 0.75);
    spawn(world, { position: { x: 1 }, collider: { radius: RADIUS } });
    run(world, 8);
    expect(world.components.Position.x[a]).toBe(0.5);
    expect(world.components.Velocity.x[a]).toBe(-6);
  });

  // A row in touch at rest: the blow goes on to its last ball, and what is faster than the ball before it hits again.
  test('hand the blow through a row that touches', () => {
    const world = worldOf();
    const ids = [ball(world, 0, 4, 0.75), ball(world, 1, 0, 0.75), ball(world, 1.5, 0, 0.75)];
    run(world, 12);
    expect(ids.map((id) => world.components.Velocity.x[id])).toEqual([0.4453125, 0.4921875, 3.0625]);
  });

  // Round numbers meet at the end of a step to a few roundings on either side: all rebound as any other pair.
  test.each([50, 60, 100, 120])('rebound with round numbers at %d Hz', (rate) => {
    const world = worldOf();
    const pairs: [a: number, b: number, speed: number][] = [];
    const start = (x: number, gap: number, speed: number) => {
      const y = pairs.length;
      const a = ball(world, x, speed, 0.8, { position: { x, y } });
      pairs.push([a, ball(world, x, 0, 0.8, { position: { x: x + 2 * RADIUS + gap, y } }), speed]);
    };
    for (let x = -2; x <= 2; x++) {
      for (let gap = 1; gap <= 10; gap++) for (let speed = 1; speed <= 6; speed++) start(x, gap / 10, speed);
    }
    for (let i = 0; i < rate + 2; i++) step(world, 1 / rate);
    const { Velocity } = world.components;
    const restitutions = pairs.map(([a, b, speed]) => (Velocity.x[b] - Velocity.x[a]) / speed);
    for (const e of restitutions) expect(e).toBeCloseTo(0.8, precision === 'f64' ? 12 : 5);
  });
});

// What touches without approach stays where it is: no impact sets it going.
test.each([0, 0.5, 1])('a row that touches without approach stays at rest, restitution %d', (restitution) => {
  const world = createPhysicsWorld({ preset: particleContacts });
  const ids = [0, 0.5, 1, 1.5].map((x) =>
    spawn(world, { position: { x }, velocity: { x: 2 }, mass: 1, collider: { radius: RADIUS, restitution } }),
  );
  run(world, 64);
  expect(ids.map((id) => world.components.Position.x[id])).toEqual([2, 2.5, 3, 3.5]);
  expect(ids.map((id) => world.components.Velocity.x[id])).toEqual([2, 2, 2, 2]);
});
