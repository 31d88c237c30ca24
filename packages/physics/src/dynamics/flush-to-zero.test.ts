import { describe, expect, it } from 'vitest';
import {
  asleepCount,
  box,
  createPhysicsWorld,
  linearDrag,
  motionEvents,
  rigidBodies,
  semiImplicitEuler,
  spawn,
  step,
} from '../index.ts';

const DT = 1 / 64;

/** The smallest normal numbers (IEEE 754). */
const LEAST_NORMAL = { f32: 2 ** -126, f64: 2 ** -1022 };

describe.each(['f32', 'f64'] as const)('tiny values in %s', (precision) => {
  const limit = precision === 'f32' ? 1e-18 : 1e-150;

  it('are zero before they are subnormal, where drag halves a velocity again and again', () => {
    const world = createPhysicsWorld({ precision, integrator: semiImplicitEuler, forces: [linearDrag()] });
    const body = spawn(world, { position: {}, velocity: { x: 1, y: -1 }, mass: 1, linearDrag: 32 });
    const { x, y } = world.components.Velocity;
    // Each step halves the velocity, exactly.
    for (let n = 1; n <= 600; n++) {
      step(world, DT);
      const expected = 2 ** -n;
      if (expected > limit) expect([x[body], y[body]]).toEqual([expected, -expected]);
      else if (x[body] !== 0) expect(x[body]).toBeGreaterThan(LEAST_NORMAL[precision]);
    }
    expect([x[body], y[body]]).toEqual([0, 0]);
  });

  it('are flushed in coordinates and angular velocities as well, and nothing larger is', () => {
    const world = createPhysicsWorld({ precision, dimensions: 3, integrator: semiImplicitEuler });
    const [small, large] = [0.9 * limit, 1.1 * limit].map((value) =>
      spawn(world, {
        position: { x: value, y: -value, z: 1 },
        angularVelocity: { x: value, y: 1, z: -value },
        mass: 1,
        inertia: 1,
      }),
    );
    const { Position, AngularVelocity } = world.components;
    const valuesOf = (id: number) =>
      [Position.x, Position.y, Position.z, AngularVelocity.x, AngularVelocity.y, AngularVelocity.z].map(
        (column) => column[id],
      );
    const before = valuesOf(large);
    for (let n = 0; n < 64; n++) step(world, DT);
    expect(valuesOf(small)).toEqual([0, 0, 1, 0, 1, 0]);
    expect(valuesOf(large)).toEqual(before);
  });
});

it('lets rigid bodies with tiny coordinates sleep on', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, precision: 'f32' });
  spawn(world, { position: { x: 1e-20, y: 1e-25 }, collider: { shape: box(1, 1), density: 1 } });
  for (let n = 0; n < 60; n++) step(world, DT);
  expect(asleepCount(world)).toBe(1);
  for (let n = 0; n < 64; n++) {
    step(world, DT);
    expect(motionEvents(world).awake.count).toBe(0);
  }
});
