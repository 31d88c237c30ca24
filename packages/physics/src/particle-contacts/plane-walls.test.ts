import { describe, expect, test } from 'vitest';
import {
  ballInertia,
  createPhysicsWorld,
  createRandom,
  particleContacts,
  semiImplicitEuler,
  spawn,
  step,
  uniformGravity,
} from '../index.ts';

describe.each([
  [2, 'f32'],
  [2, 'f64'],
  [3, 'f32'],
  [3, 'f64'],
] as const)('in %d D, %s', (dimensions, precision) => {
  const digits = precision === 'f64' ? 10 : 4;

  test('an oblique plane reflects a ball at the time of impact', () => {
    const world = createPhysicsWorld({ preset: particleContacts, dimensions, precision });
    const [nx, ny, nz] = dimensions === 2 ? [0.6, 0.8, 0] : [0.48, 0.64, 0.6];
    spawn(world, { planeWall: { nx: 2 * nx, ny: 2 * ny, nz: 2 * nz, offset: 1, restitution: 0.5 } });
    const v = { x: -3, y: -4, ...(dimensions === 3 ? { z: 1 } : {}) };
    const ball = spawn(world, { position: { x: 5 * nx, y: 5 * ny, z: 5 * nz }, velocity: v, mass: 1, collider: 0.5 });
    for (let i = 0; i < 150; i++) step(world, 0.01);
    const into = v.x * nx + v.y * ny + (v.z ?? 0) * nz;
    const [p, u] = [world.components.Position, world.components.Velocity];
    expect(u.x[ball]).toBeCloseTo(v.x - 1.5 * into * nx, digits);
    expect(u.y[ball]).toBeCloseTo(v.y - 1.5 * into * ny, digits);
    expect(u.z[ball]).toBeCloseTo((v.z ?? 0) - 1.5 * into * nz, digits);
    // The ball covers 3.5 m at `into` and returns at half that speed for the remaining time.
    const height = 1.5 + 0.5 * -into * (1.5 - 3.5 / -into);
    expect(p.x[ball] * nx + p.y[ball] * ny + p.z[ball] * nz).toBeCloseTo(height, digits);
  });
});

test('a ball in a corner of three planes bounces to heights that fall by e²', () => {
  // Gravity 20, radius 20, planes at -100, restitution 0.9: the ball falls 180 from 100 to its resting height of -80.
  const world = createPhysicsWorld({ preset: particleContacts, dimensions: 3, forces: [uniformGravity({ y: -20 })] });
  for (const normal of [{ nx: 1, ny: 0 }, { ny: 1 }, { ny: 0, nz: 1 }]) {
    spawn(world, { planeWall: { ...normal, offset: -100, restitution: 0.9 } });
  }
  const ball = spawn(world, { position: { x: 100, z: 0 }, velocity: { x: -20, z: -20 }, mass: 1, collider: 20 });
  const [p, v] = [world.components.Position, world.components.Velocity];
  const apexes: number[] = [];
  let [before, last] = [0, 0];
  for (let i = 0; i < 1000; i++) {
    step(world, 1 / 60);
    if (last > before && last > p.y[ball]) apexes.push(last + 80);
    [before, last] = [last, p.y[ball]];
  }
  expect(apexes[0]).toBeCloseTo(64.8, 1);
  expect(apexes[1]).toBeCloseTo(52.488, 1);
  // It has rebounded from the planes x and z at nine tenths of its speed.
  expect(v.x[ball]).toBeCloseTo(18, 9);
  expect(v.z[ball]).toBeCloseTo(18, 9);
});

test('a ball on a slope slides or rolls by its friction', () => {
  const slope = (friction: number, integrator = semiImplicitEuler) => {
    const world = createPhysicsWorld({
      preset: particleContacts,
      dimensions: 3,
      integrator,
      forces: [uniformGravity({ y: -10 })],
    });
    spawn(world, { planeWall: { nx: 0.6, ny: 0.8, offset: 0 } });
    const ball = spawn(world, {
      position: { x: 0.3, y: 0.4 },
      velocity: {},
      mass: 3,
      inertia: ballInertia(3, 0.5),
      angularVelocity: {},
      collider: { radius: 0.5, friction },
    });
    for (let i = 0; i < 100; i++) step(world, 0.01);
    const { x, y } = world.components.Velocity;
    return Math.hypot(x[ball], y[ball]);
  };
  // The geometric mean of the wall's coefficient 1 and the body's μ² is μ. Sliding: g (sin θ - μ cos θ); rolling: 5/7 g
  // sin θ.
  expect(slope(0)).toBeCloseTo(6, 9);
  expect(slope(0.01)).toBeCloseTo(6 - 0.1 * 8, 6);
  expect(slope(1)).toBeCloseTo((5 / 7) * 6, 6);
});

test('bodies do not leave a wedge of planes', () => {
  const world = createPhysicsWorld({ preset: particleContacts, forces: [uniformGravity({ y: -10 })] });
  spawn(world, { planeWall: { nx: 1, ny: 0.5, offset: 0, restitution: 0.9 } });
  spawn(world, { planeWall: { nx: -1, ny: 0.5, offset: 0, restitution: 0.9 } });
  const random = createRandom(1);
  const balls = Array.from({ length: 100 }, () =>
    spawn(world, {
      position: { y: random.uniform(5, 9) },
      velocity: { x: random.uniform(-900, 900) },
      mass: 1,
      collider: 0.1,
    }),
  );
  world.phases.collide.length = 0;
  for (let i = 0; i < 300; i++) {
    step(world, 1 / 60);
    const { x, y } = world.components.Position;
    for (const ball of balls) {
      const deepest = (0.5 * y[ball] - Math.abs(x[ball])) / Math.sqrt(1.25) - 0.1;
      expect(deepest).toBeGreaterThan(-0.01);
    }
  }
});
