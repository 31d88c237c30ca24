// Impacts that velocities at the start of a step do not predict carry bodies metres along each other within it. Without restitution
// nothing gains energy by them.
import {
  box,
  createPhysicsWorld,
  createRandom,
  energy,
  type PhysicsWorld,
  rigidBodies,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT } from '../../../../test/support/rigid-world.ts';

/** Rounding of sums of squares. */
const ROUNDING = 1e-5;

/** The largest kinetic energy of a few steps, as a part of that of the start. */
function growth(world: PhysicsWorld, dt = DT): number {
  const start = energy(world).kinetic;
  let most = 0;
  for (let i = 0; i < 5; i++) {
    step(world, dt);
    most = Math.max(most, energy(world).kinetic / start);
  }
  return most;
}

describe.each(['f32', 'f64'] as const)('in %s, kinetic energy does not grow', (precision) => {
  const empty = () => createPhysicsWorld({ preset: rigidBodies, precision, capacity: 100 });

  // Three discs fly into the corner between a wall and a box, whose tilt decides about points that are seen ahead.
  test.each([
    [60, DT],
    [40, DT],
    [30, 2 * DT],
  ])('where discs of %d m/s strike a box beside a wall, steps of %f s', (speed, dt) => {
    for (let k = 0; k < 60; k++) {
      const world = empty();
      spawn(world, { position: { x: 1.05, y: 2 }, collider: { shape: box(1, 4) } });
      spawn(world, { position: { y: 0.5 }, rotation: -0.001, mass: 86.4, collider: { shape: box(1, 1) } });
      const velocity = { x: 0.8 * speed, y: -0.6 * speed };
      for (const [x, y] of [
        [-0.56, 1.72],
        [-0.56, 1.94],
        [-0.34, 1.94],
      ]) {
        spawn(world, { position: { x: x - 0.2 + 0.007 * k, y }, velocity, mass: 2, collider: { radius: 0.1 } });
      }
      expect(growth(world, dt), `${k}`).toBeLessThan(1 + ROUNDING);
    }
  });

  // A shot of pellets into a stack beside a wall that stands, of a static body or a kinematic one.
  test.each([
    ['static', 60],
    ['static', 400],
    ['kinematic', 100],
  ])('where pellets strike a stack beside a %s wall at %d m/s', (kind, speed) => {
    for (let seed = 1; seed <= 40; seed++) {
      const random = createRandom(seed);
      const world = empty();
      spawn(world, { position: { y: -0.5 }, collider: { shape: box(60, 1) } });
      const stands = kind === 'static' ? {} : { kinematic: {}, velocity: {} };
      spawn(world, { position: { x: 1.05, y: 2 }, ...stands, collider: { shape: box(1, 4) } });
      for (let i = 0; i < 12; i++) {
        const position = { x: -1.02 * (i % 3), y: 0.5 + 1.005 * Math.floor(i / 3) };
        const collider = { shape: box(1, 1), density: random.uniform(50, 130) };
        spawn(world, { position, rotation: random.uniform(-0.002, 0.002), collider });
      }
      const angle = random.uniform(-1.2, -0.4);
      const velocity = { x: speed * Math.cos(angle), y: speed * Math.sin(angle) };
      for (let i = 0; i < 16; i++) {
        const position = { x: -1 + 0.22 * (i % 4), y: 4.5 + 0.22 * Math.floor(i / 4) };
        spawn(world, { position, velocity, mass: 2, collider: { radius: 0.1 } });
      }
      expect(growth(world), `${seed}`).toBeLessThan(1 + ROUNDING);
    }
  });
});
