import { createJoint, distance, energy, PhysicsError, revolute, spawn, step, wheel } from '@principia/physics';
import { expect, it } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const HERTZ = 0.5;
const OMEGA = 2 * Math.PI * HERTZ;
const LENGTH = 4;
const cord = { hertz: HERTZ, dampingRatio: 0, maxCompression: 0 };

/** A jumper of 70 kg on a cord that hangs at the origin. */
function jump(precision: 'f32' | 'f64', y: number, spring: { dampingRatio?: number } = {}) {
  const world = rigidWorld({ precision });
  const b = spawn(world, { position: { y }, velocity: {}, mass: 70, collider: 0.3 });
  createJoint(world, distance({ b, anchorA: {}, length: LENGTH, spring: { ...cord, ...spring } }));
  return { world, b, height: () => world.components.Position.y[b], speed: () => world.components.Velocity.y[b] };
}

it.each(['f32', 'f64'] as const)(
  'leaves a jumper in free fall until the cord is taut, and stops where its energy says: %s',
  (precision) => {
    const { world, height, speed } = jump(precision, -0.5);
    const start = energy(world).total;
    while (height() > -LENGTH + 0.2) {
      // Semi-implicit Euler falls by half a sub-step's speed less than t² says.
      expect(speed()).toBeCloseTo(-G * world.time, 4);
      step(world, DT);
    }
    let lowest = 0;
    while (speed() < 0) {
      step(world, DT);
      lowest = Math.min(lowest, height());
    }
    // g (L + x - 0.5) = ½ ω² x²
    const stretch = (G + Math.sqrt(G * G + 2 * OMEGA * OMEGA * G * (LENGTH - 0.5))) / (OMEGA * OMEGA);
    // The energy is kept within hω/2 of what moves to and fro.
    expect(Math.abs(-lowest - LENGTH - stretch)).toBeLessThan(0.125 * DT * OMEGA * stretch + G * DT * DT);
    expect(Math.abs(energy(world).total - start)).toBeLessThan(0.125 * DT * OMEGA * 70 * G * (LENGTH + stretch));
  },
);

it('exerts nothing while it is slack, however much it damps', () => {
  const { world, b, height } = jump('f64', -1, { dampingRatio: 50 });
  world.components.Velocity.x[b] = 3;
  run(world, 30 * DT);
  expect(height()).toBeGreaterThan(-LENGTH);
  // Four sub-steps of h fall by g h² (n² + n)/2.
  expect(height()).toBeCloseTo(-1 - (G * (DT / 4) ** 2 * 120 * 121) / 2, 9);
  expect(world.components.Velocity.x[b]).toBe(3);
});

it('pushes with no more than it may, and pulls with more', () => {
  const world = rigidWorld({ precision: 'f64', forces: [] });
  const spring = { hertz: 1, dampingRatio: 0, maxForce: 500, maxCompression: 2 };
  const near = spawn(world, { position: { x: 1 }, velocity: {}, mass: 4, collider: 0.1 });
  const far = spawn(world, { position: { x: 3, y: 5 }, velocity: {}, mass: 4, collider: 0.1 });
  createJoint(world, distance({ b: near, anchorA: {}, length: 2, spring }));
  createJoint(world, distance({ b: far, anchorA: { y: 5 }, length: 2, spring }));
  run(world, DT);
  expect(world.components.Velocity.x[near]).toBeCloseTo((2 / 4) * DT, 9);
  // It would be ω² x t = 0.66 m/s if its stretch stayed 1 m, and nothing keeps it below.
  expect(world.components.Velocity.x[far]).toBeLessThan(-0.64);
});

it('refuses bounds of force where no spring has any', () => {
  const refused = (make: () => unknown, field: string) => {
    let error: unknown;
    try {
      make();
    } catch (caught) {
      error = caught;
    }
    expect(error).toBeInstanceOf(PhysicsError);
    expect((error as PhysicsError).code).toBe('E_UNKNOWN');
    expect((error as PhysicsError).message).toContain(field);
  };
  const spring = { hertz: 1, maxForce: 3 };
  refused(() => wheel({ b: 1, anchor: {}, spring }), 'maxForce');
  refused(() => revolute({ b: 1, anchor: {}, spring: { hertz: 1, maxCompression: 3 } as never }), 'maxCompression');
  expect(() => distance({ b: 1, spring: { hertz: 1, maxCompression: -1 } })).toThrow('spring.maxCompression');
});
