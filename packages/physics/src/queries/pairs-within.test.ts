import { createPhysicsWorld, createRandom, type PhysicsWorld, pairsWithin, spawn, spawnMany } from '@principia/physics';
import { describe, expect, test } from 'vitest';

/** All pairs, by looking at each. */
function everyPair(world: PhysicsWorld, distance: number, ids: readonly number[]): string[] {
  const { x, y, z } = world.components.Position;
  const found: string[] = [];
  for (const a of ids) {
    for (const b of ids) {
      const [dx, dy, dz] = [x[b] - x[a], y[b] - y[a], z[b] - z[a]];
      if (a < b && dx * dx + dy * dy + dz * dz <= distance * distance) found.push(`${a} ${b}`);
    }
  }
  return found.sort();
}

function pairsOf(world: PhysicsWorld, distance: number, among?: ArrayLike<number>): string[] {
  const { count, a, b } = pairsWithin(world, distance, among);
  return Array.from({ length: count }, (_, i) => `${a[i]} ${b[i]}`).sort();
}

const COUNT = 400;
const IDS = Array.from({ length: COUNT }, (_, i) => i + 1);

describe.each([2, 3] as const)('in %i dimensions', (dimensions) => {
  describe.each(['f32', 'f64'] as const)('%s', (precision) => {
    function crowd(seed: number, spread: number): PhysicsWorld {
      const random = createRandom(seed);
      const world = createPhysicsWorld({ dimensions, precision, capacity: COUNT });
      const axis = () => Float64Array.from({ length: COUNT }, () => random.uniform(-spread, spread));
      spawnMany(world, COUNT, { position: { x: axis(), y: axis(), ...(dimensions === 3 ? { z: axis() } : {}) } });
      return world;
    }

    test.each([
      [0.3, 10],
      [2, 10],
      [40, 10],
      [1e-3, 0.01],
      [1, 1e5],
    ])('within %f m, bodies spread over %f m: the same as by comparing all, each once', (distance, spread) => {
      for (let seed = 1; seed <= 5; seed++) {
        const world = crowd(seed, spread);
        expect(pairsOf(world, distance)).toEqual(everyPair(world, distance, IDS));
      }
    });

    test.each([1e3, 1e9, 1e13])('%f m from the origin, on a lattice as wide as the distance', (offset) => {
      // Multiples of what is certain to be a sum without rounding.
      const spacing = Math.max(1, offset * (precision === 'f32' ? 2 ** -20 : 2 ** -50));
      const world = createPhysicsWorld({ dimensions, precision });
      const at = (i: number) => offset + i * spacing;
      for (let i = 0; i < 12; i++) for (let j = 0; j < 12; j++) spawn(world, { position: { x: at(i), y: -at(j) } });
      const ids = IDS.slice(0, 144);
      expect(pairsOf(world, spacing)).toEqual(everyPair(world, spacing, ids));
    });

    test('among some bodies', () => {
      const world = crowd(9, 5);
      const some = IDS.filter((id) => id % 3 === 0);
      expect(pairsOf(world, 1, some)).toEqual(everyPair(world, 1, some));
      expect(pairsOf(world, 1, [])).toEqual([]);
    });

    test('far from the origin, where cells of this size could not be counted', () => {
      const world = createPhysicsWorld({ dimensions, precision });
      for (const x of [1e15, 1e15, -1e15, 0, 1e-4]) spawn(world, { position: { x, y: x } });
      expect(pairsOf(world, 1e-3)).toEqual(['1 2', '4 5']);
    });
  });
});

test('a distance is included, and the arrays stay', () => {
  const world = createPhysicsWorld();
  for (const x of [0, 3, 3]) spawn(world, { position: { x, y: x === 0 ? 0 : 4 } });
  expect(pairsOf(world, 5)).toEqual(['1 2', '1 3', '2 3']);
  expect(pairsOf(world, 4.999)).toEqual(['2 3']);
  const { a } = pairsWithin(world, 5);
  expect(pairsWithin(world, 1).a).toBe(a);
});

test.each([Number.NaN, Infinity])('a body whose position is %f is near nothing', (value) => {
  const world = createPhysicsWorld();
  for (const x of [0, 0.1, 0.2]) spawn(world, { position: { x } });
  world.components.Position.x[2] = value;
  expect(pairsOf(world, 1)).toEqual(['1 3']);
  world.components.Position.y[2] = value;
  expect(pairsOf(world, 1)).toEqual(['1 3']);
});

test.each([
  ['no distance', 'E_TYPE', [undefined]],
  ['a distance of 0', 'E_RANGE', [0]],
  ['an infinite distance', 'E_NONFINITE', [Infinity]],
  ['no list', 'E_TYPE', [1, 7]],
  ['a body that is not there', 'E_RANGE', [1, [1, 9]]],
  ['a list that is not ascending', 'E_RANGE', [1, [2, 1]]],
  ['a body twice', 'E_RANGE', [1, [2, 2]]],
])('%s is refused', (_, code, args) => {
  const world = createPhysicsWorld();
  for (const x of [0, 1, 2]) spawn(world, { position: { x } });
  const call = pairsWithin as unknown as (...args: unknown[]) => unknown;
  expect(() => call(world, ...args)).toThrow(expect.objectContaining({ code }));
});
