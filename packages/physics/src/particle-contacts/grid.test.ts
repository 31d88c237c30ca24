// Compares the grid with a brute-force search over all pairs.
import { describe, expect, test } from 'vitest';
import {
  contacts,
  createPhysicsWorld,
  createRandom,
  type PhysicsWorld,
  particleContacts,
  spawn,
  spawnMany,
  step,
} from '../index.ts';

/** The step is so short that no body moves. */
const INSTANT = 1e-9;

interface Crowd {
  readonly count: number;
  readonly side: number;
  readonly radius: (uniform: number, index: number) => number;
  readonly origin?: number;
  /** Aspect ratio (height / width) of the region. */
  readonly shape?: number;
}

function crowd(
  dimensions: 2 | 3,
  precision: 'f32' | 'f64',
  { count, side, radius, origin = 0, shape = 1 }: Crowd,
): PhysicsWorld {
  const world = createPhysicsWorld({ preset: particleContacts, dimensions, precision, capacity: count });
  const random = createRandom(count);
  const place = (scale: number) =>
    Float64Array.from({ length: count }, () => origin + random.uniform(-0.5, 0.5) * side * scale);
  spawnMany(world, count, {
    position: { x: place(1), y: place(shape), ...(dimensions === 3 ? { z: place(1) } : {}) },
    velocity: {},
    mass: 1,
    collider: Float64Array.from({ length: count }, (_, i) => radius(random.uniform(0, 1), i)),
  });
  return world;
}

function touching(world: PhysicsWorld): string[] {
  const { x, y, z } = world.components.Position;
  const { radius } = world.components.Collider;
  const found: string[] = [];
  for (let a = 1; a <= world.lastId; a++) {
    for (let b = a + 1; b <= world.lastId; b++) {
      const reach = radius[a] + radius[b];
      const [dx, dy, dz] = [x[b] - x[a], y[b] - y[a], z[b] - z[a]];
      if (dx * dx + dy * dy + dz * dz < reach * reach) found.push(`${a} ${b}`);
    }
  }
  return found;
}

function found(world: PhysicsWorld): string[] {
  const { count, a, b } = contacts(world);
  return Array.from({ length: count }, (_, i) => `${a[i]} ${b[i]}`);
}

const CROWDS: Record<string, Crowd> = {
  'equal bodies': { count: 600, side: 20, radius: () => 0.5 },
  'bodies of all sizes': { count: 600, side: 30, radius: (u) => 0.05 + u * u * u },
  'a few giants among the small': { count: 600, side: 100, radius: (_, i) => (i % 100 === 0 ? 20 : 0.7) },
  'more giants than may stay out of the grid': { count: 300, side: 60, radius: (_, i) => (i % 10 === 0 ? 5 : 0.3) },
  'fewer bodies than giants may be': { count: 10, side: 3, radius: (u) => 0.1 + u },
  'many giants in a heap of the small': {
    count: 1500,
    side: 30,
    radius: (_, i) => (i % 50 === 0 ? 3 : 0.05),
  },
  'far from the origin': { count: 400, side: 16, radius: () => 0.5, origin: -30_000 },
  'a long strip': { count: 500, side: 3000, radius: () => 2, shape: 0.001 },
  'a tall strip': { count: 500, side: 4, radius: () => 2, shape: 800 },
  'hardly anything in much space': { count: 300, side: 1e7, radius: (u) => 1000 * u + 1 },
};

describe.each([
  [2, 'f32'],
  [2, 'f64'],
  [3, 'f32'],
  [3, 'f64'],
] as const)('in %d D, %s', (dimensions, precision) => {
  test.each(Object.keys(CROWDS))('%s: finds each touching pair once', (name) => {
    const world = crowd(dimensions, precision, CROWDS[name]);
    const expected = touching(world);
    step(world, INSTANT);
    // A pair that just touches may round differently in f32 and f64.
    const differ = new Set(expected);
    const extra = found(world).filter((pair) => !differ.delete(pair));
    expect(extra.length + differ.size).toBeLessThanOrEqual(precision === 'f32' ? 2 : 0);
    expect(expected.length).toBeGreaterThan(name.startsWith('hardly') || dimensions === 3 ? -1 : 5);
  });
});

test('a touching pair ten million kilometres from the origin is found in f64', () => {
  const world = createPhysicsWorld({ preset: particleContacts });
  for (const x of [1e10, 1e10 + 1.9]) spawn(world, { position: { x, y: -1e10 }, velocity: {}, mass: 1, collider: 1 });
  spawn(world, { position: { x: -1e15 }, velocity: {}, mass: 1, collider: 1 });
  step(world, INSTANT);
  expect(found(world)).toEqual(['1 2']);
});

test('immovable bodies are not paired, nor are entities without collider or position', () => {
  const world = createPhysicsWorld({ preset: particleContacts });
  spawn(world, { position: {}, collider: 1 });
  spawn(world, { position: { x: 1 }, collider: 1 });
  spawn(world, { position: {}, velocity: {}, mass: 1 });
  spawn(world, { collider: 1, mass: 1 });
  step(world, INSTANT);
  expect(found(world)).toEqual([]);
  spawn(world, { position: {}, velocity: {}, mass: 1, collider: 1 });
  step(world, INSTANT);
  expect(found(world)).toEqual(['1 5', '2 5']);
});

test.each([2, 3] as const)(
  'many bodies in one cell cost a bounded number of tests, and dropped candidates are counted, %d D',
  (dimensions) => {
    // Twenty bodies make the cells wide, and lie so far apart that all seem to have room in them; the points are too many for a
    // brute-force search.
    const world = createPhysicsWorld({ preset: particleContacts, dimensions, precision: 'f32', capacity: 20_020 });
    const random = createRandom(1);
    const place = () => Float64Array.from({ length: 20_000 }, () => random.uniform(0, 1));
    const far = Float64Array.from({ length: 20 }, (_, i) => 1e6 * (i + 1));
    spawnMany(world, 20, {
      position: { x: far, y: far },
      velocity: {},
      mass: 1,
      collider: 4,
    });
    spawnMany(world, 20_000, {
      position: { x: place(), y: place(), ...(dimensions === 3 ? { z: place() } : {}) },
      velocity: {},
      mass: 1,
      collider: 1e-7,
    });
    step(world, 0.01);
    expect(contacts(world).droppedCount).toBeGreaterThan(1e8 / 2);
  },
);

test.each([
  [2, 'f32'],
  [3, 'f64'],
] as const)('boulders among grains cost few tests, and no contact is lost, %d D, %s', (dimensions, precision) => {
  const [grains, boulders] = [10_000, 30];
  const world = createPhysicsWorld({ preset: particleContacts, dimensions, precision, capacity: 2 * grains });
  const random = createRandom(5);
  const place = () => Float64Array.from({ length: grains + boulders }, () => random.uniform(-10, 10));
  spawnMany(world, grains + boulders, {
    position: { x: place(), y: place(), ...(dimensions === 3 ? { z: place() } : {}) },
    velocity: {},
    mass: 1,
    collider: Float64Array.from({ length: grains + boulders }, (_, i) => (i < grains ? 0.05 : 3)),
  });
  step(world, INSTANT);
  // In cells of 6 m every grain would be tested against thousands of others, of which 4096 are tested at most.
  expect(contacts(world).droppedCount).toBe(0);
  const { x, y, z } = world.components.Position;
  let onFirst = 0;
  for (let id = 1; id <= grains; id++) {
    const b = grains + 1;
    if (Math.hypot(x[id] - x[b], y[id] - y[b], z[id] - z[b]) < 3.05) onFirst++;
  }
  expect(found(world).filter((pair) => pair.endsWith(` ${grains + 1}`)).length).toBe(onFirst);
});
