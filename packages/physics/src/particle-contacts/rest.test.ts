import { describe, expect, test } from 'vitest';
import {
  boxWalls,
  contacts,
  createPhysicsWorld,
  createRandom,
  energy,
  type PhysicsWorld,
  particleContacts,
  semiImplicitEuler,
  spawn,
  step,
  uniformGravity,
  velocityVerlet,
  wallContacts,
} from '../index.ts';

const G = 10;
const DT = 1 / 60;

function stackWorld(parts: { dimensions?: 2 | 3; precision?: 'f32' | 'f64'; euler?: boolean } = {}): PhysicsWorld {
  const { dimensions = 2, precision = 'f64', euler = false } = parts;
  return createPhysicsWorld({
    preset: particleContacts,
    dimensions,
    precision,
    capacity: 500,
    integrator: euler ? semiImplicitEuler : velocityVerlet,
    forces: [uniformGravity({ y: -G })],
    walls: [boxWalls({ min: { x: -3, y: 0, z: -3 }, max: { x: 3, z: 3 } })],
  });
}

function stack(world: PhysicsWorld, masses: readonly number[], restitution: number): number[] {
  return masses.map((mass, i) =>
    spawn(world, { position: { y: 0.5 + i }, velocity: {}, mass, collider: { radius: 0.5, restitution } }),
  );
}

const run = (world: PhysicsWorld, steps: number) => {
  for (let i = 0; i < steps; i++) step(world, DT);
};

describe.each([
  [2, 'f64', false],
  [2, 'f32', false],
  [3, 'f64', false],
  [2, 'f64', true],
] as const)('a stack of five in %d D, %s, Euler %s', (dimensions, precision, euler) => {
  test.each([0, 0.5, 0.9])('with restitution %d each contact carries the weight above it', (restitution) => {
    const world = stackWorld({ dimensions, precision, euler });
    const ids = stack(world, [1, 2, 1, 3, 1], restitution);
    run(world, 400);
    const found = contacts(world);
    const weights = [7, 5, 4, 1];
    expect(found.count).toBe(4);
    for (let i = 0; i < 4; i++) {
      expect([found.a[i], found.b[i]]).toEqual([ids[i], ids[i + 1]]);
      expect(found.impulse[i] / (weights[i] * G * DT)).toBeCloseTo(1, 2);
      expect(found.ny[i]).toBeCloseTo(1, 6);
    }
    const floor = wallContacts(world);
    expect(floor.count).toBe(1);
    expect(floor.impulse[0] / (8 * G * DT)).toBeCloseTo(1, 2);
    const { y } = world.components.Position;
    ids.forEach((id, i) => {
      expect(Math.abs(y[id] - (0.5 + i))).toBeLessThan(0.01);
      expect(Math.abs(world.components.Velocity.y[id])).toBeLessThan(0.01 * G * DT);
    });
  });
});

test('a ball on the floor between two walls stays bitwise at rest', () => {
  const world = stackWorld();
  const [ball] = stack(world, [1], 0.6);
  run(world, 200);
  const { y } = world.components.Position;
  const before = y[ball];
  for (let i = 0; i < 100; i++) {
    step(world, DT);
    expect(y[ball]).toBe(before);
  }
});

describe.each(['f32', 'f64'] as const)('piles, %s', (precision) => {
  test.each([
    [0, 0],
    [0.4, 0.3],
  ])('sixty discs with restitution %d and friction %d come to rest', (restitution, friction) => {
    // The final state of a pile varies, and sometimes a disc is still moving, so the median of five piles is tested.
    const energies: number[] = [];
    const loads: number[] = [];
    for (let seed = 1; seed <= 5; seed++) {
      const world = heap(precision, seed, restitution, friction);
      run(world, 1800);
      energies.push(energy(world).kinetic / 60);
      loads.push(upwardImpulse(world) / (60 * G * DT));
      expect(largestOverlap(world)).toBeLessThan(0.05);
    }
    // The limit is the kinetic energy that gravity gives a disc in one step.
    expect(median(energies)).toBeLessThan((G * DT) ** 2 / 2);
    // The sum of the upward impulses of the floor and the side walls equals the weight.
    expect(median(loads)).toBeCloseTo(1, 1);
  });
});

function heap(precision: 'f32' | 'f64', seed: number, restitution: number, friction: number): PhysicsWorld {
  const world = stackWorld({ precision });
  const random = createRandom(seed);
  for (let i = 0; i < 60; i++) {
    spawn(world, {
      position: { x: -2.5 + (i % 6) + random.uniform(-0.05, 0.05), y: 0.6 + 1.1 * Math.floor(i / 6) },
      velocity: {},
      mass: 1,
      inertia: 0.05,
      angularVelocity: {},
      collider: { radius: random.uniform(0.25, 0.5), restitution, friction },
    });
  }
  return world;
}

/** Largest overlap of two touching discs, relative to the sum of their radii. */
function largestOverlap(world: PhysicsWorld): number {
  const found = contacts(world);
  const { Position: p, Collider } = world.components;
  let largest = 0;
  for (let i = 0; i < found.count; i++) {
    const [a, b] = [found.a[i], found.b[i]];
    const reach = Collider.radius[a] + Collider.radius[b];
    largest = Math.max(largest, 1 - Math.hypot(p.x[a] - p.x[b], p.y[a] - p.y[b]) / reach);
  }
  return largest;
}

function upwardImpulse(world: PhysicsWorld): number {
  const { count, impulse, ny } = wallContacts(world);
  let up = 0;
  for (let k = 0; k < count; k++) up += impulse[k] * ny[k];
  return up;
}

function median(values: readonly number[]): number {
  return values.toSorted((a, b) => a - b)[values.length >> 1];
}

test('a million times heavier ball rests on a light one', () => {
  for (const precision of ['f32', 'f64'] as const) {
    const world = stackWorld({ precision });
    const [light, heavy] = stack(world, [1, 1e6], 0);
    run(world, 600);
    const { y } = world.components.Position;
    expect(y[light]).toBeCloseTo(0.5, 3);
    expect(y[heavy] - y[light]).toBeGreaterThan(0.9);
  }
});

test('a stack on an immovable body carries its weight too', () => {
  const world = createPhysicsWorld({ preset: particleContacts, forces: [uniformGravity({ y: -G })] });
  spawn(world, { position: {}, collider: 0.5 });
  const top = spawn(world, { position: { y: 1 }, velocity: {}, mass: 3, collider: 0.5 });
  run(world, 100);
  expect(contacts(world).impulse[0] / (3 * G * DT)).toBeCloseTo(1, 6);
  expect(world.components.Position.y[top]).toBeCloseTo(1, 6);
});

test('a step of another length warm starts with the same force', () => {
  const world = stackWorld();
  const ids = stack(world, [1, 1, 1, 1, 1, 1], 0);
  run(world, 400);
  const speeds = () => Math.max(...ids.map((id) => Math.abs(world.components.Velocity.y[id])));
  for (const dt of [DT / 4, DT, DT / 2]) {
    step(world, dt);
    expect(speeds()).toBeLessThan(0.02 * G * dt);
  }
});

test('elastic balls that fall into a box conserve energy, except in steps with simultaneous floor and ball contacts', () => {
  const world = stackWorld();
  const random = createRandom(3);
  for (let i = 0; i < 20; i++) {
    spawn(world, {
      position: { x: random.uniform(-2.5, 2.5), y: 1 + i },
      velocity: {},
      mass: 1,
      collider: { radius: 0.3, restitution: 1 },
    });
  }
  const before = energy(world).total;
  run(world, 600);
  // A body that hits the floor and another body within one step is placed on the floor, a displacement of at most its
  // motion in a step.
  expect(Math.abs(energy(world).total / before - 1)).toBeLessThan(0.01);
});
