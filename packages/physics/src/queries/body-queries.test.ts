import { describe, expect, test } from 'vitest';
import {
  bodyAt,
  box,
  capsule,
  castShape,
  castShapeAll,
  circle,
  createPhysicsWorld,
  createRandom,
  nearestPoint,
  overlapShape,
  PhysicsError,
  type PhysicsWorld,
  polygon,
  rayCast,
  rayCastAll,
  rigidBodies,
  type Shape,
  segment,
  spawn,
  spawnCompound,
  standard,
} from '../index.ts';

const close = (value: number, digits = 10) => expect.closeTo(value, digits);

/** A world with one body of each shape. */
function worldWith(...bodies: readonly [shape: Shape, x: number, y: number, angle?: number][]) {
  const world = createPhysicsWorld({ capacity: 1000 });
  const ids = bodies.map(([shape, x, y, angle = 0]) =>
    spawn(world, { position: { x, y }, rotation: angle, collider: { shape } }),
  );
  return { world, ids };
}

describe('a ray', () => {
  test('enters a box through its side, a disc and a capsule on their arcs', () => {
    const { world, ids } = worldWith([box(2, 1), 5, 0], [circle(1), 10, 0.6], [capsule(2, 0.5), 15, 0.3]);
    const hits = rayCastAll(world, { x: 0 }, { x: 20 });
    expect(hits.map(({ body }) => body)).toEqual(ids);
    expect(hits[0]).toMatchObject({ fraction: close(0.2), x: close(4), y: 0, nx: -1, ny: 0 });
    // The disc is entered 0.8 m before its centre, where its normal is (-0.8, -0.6).
    expect(hits[1]).toMatchObject({ x: close(9.2), nx: close(-0.8), ny: close(-0.6) });
    // The cap about x = 14 is entered 0.4 m before it.
    expect(hits[2]).toMatchObject({ x: close(13.6), nx: close(-0.8), ny: close(-0.6) });
    expect(rayCast(world, { x: 0 }, { x: 20 })).toEqual(hits[0]);
  });

  test('enters a turned box where its corner is', () => {
    const { world } = worldWith([box(1, 1), 3, 0, Math.PI / 4]);
    const hit = rayCast(world, { x: 0, y: 0.1 }, { x: 6, y: 0.1 });
    expect(hit).toMatchObject({ x: close(3 - Math.SQRT1_2 + 0.1), nx: close(-Math.SQRT1_2), ny: close(Math.SQRT1_2) });
  });

  test('enters a rounded box on its arc', () => {
    const { world } = worldWith([box(2, 2, { rounding: 0.5 }), 5, 0]);
    // The arc about (4.5, 0.5) is entered 0.4 m before its centre at a height of 0.3 m above it.
    const hit = rayCast(world, { x: 0, y: 0.8 }, { x: 10, y: 0.8 });
    expect(hit).toMatchObject({ x: close(4.1), nx: close(-0.8), ny: close(0.6) });
  });

  test('meets a segment from both sides, and passes beside it', () => {
    const { world } = worldWith([segment({ y: -1 }, { y: 1 }), 2, 0]);
    expect(rayCast(world, { x: 0 }, { x: 4 })).toMatchObject({ x: close(2), nx: close(-1) });
    expect(rayCast(world, { x: 4 }, { x: 0 })).toMatchObject({ x: close(2), nx: close(1) });
    expect(rayCast(world, { x: 0, y: 1.01 }, { x: 4, y: 1.01 })).toBeUndefined();
  });

  test('that starts inside a body, ends before one or points away from it does not enter it', () => {
    const { world } = worldWith([box(2, 2, { rounding: 0.3 }), 0, 0], [circle(1), 5, 0]);
    expect(rayCastAll(world, { x: 0 }, { x: 3.9 })).toEqual([]);
    expect(rayCastAll(world, { x: 0.95 }, { x: 3.9 })).toEqual([]);
    expect(rayCastAll(world, { x: 7 }, { x: 9 })).toEqual([]);
    expect(rayCastAll(world, { x: 0 }, { x: 4.1 })).toHaveLength(1);
  });

  test('agrees with a shape of almost no size that is cast the same way', () => {
    const random = createRandom(3);
    const shapes = [box(1, 0.5), box(1, 1, { rounding: 0.2 }), capsule(1, 0.3), circle(0.6)];
    const { world } = worldWith(
      ...shapes.map((shape): [Shape, number, number, number] => [
        shape,
        random.uniform(-3, 3),
        random.uniform(-3, 3),
        random.uniform(0, 6),
      ]),
    );
    let hits = 0;
    for (let i = 0; i < 500; i++) {
      const from = { x: random.uniform(-6, 6), y: random.uniform(-6, 6) };
      const to = { x: random.uniform(-6, 6), y: random.uniform(-6, 6) };
      const point = circle(1e-5);
      if (overlapShape(world, point, from).length > 0) continue;
      const ray = rayCast(world, from, to);
      const cast = castShape(world, point, from, { x: to.x - from.x, y: to.y - from.y });
      // Only a ray that grazes a surface may differ, because a cast ends 0.1 mm before.
      if (ray === undefined || cast === undefined) continue;
      hits++;
      expect(cast.body).toBe(ray.body);
      const slope = Math.abs((ray.nx * (to.x - from.x) + ray.ny * (to.y - from.y)) * (ray.fraction - cast.fraction));
      expect(slope).toBeLessThan(2e-4);
    }
    expect(hits).toBeGreaterThan(100);
  });
});

describe('a filter', () => {
  test('leaves out a compound body with all its parts, or one part alone', () => {
    const world = createPhysicsWorld({ preset: rigidBodies, capacity: 50 });
    const part = (x: number) => ({ shape: box(1, 1), density: 1, x });
    const { body, parts } = spawnCompound(world, { position: {}, parts: [part(-2), part(2)] });
    const other = spawn(world, { position: { x: 4 }, collider: { shape: box(1, 1) } });
    const seen = (ignore: number) => rayCastAll(world, {}, { x: 9 }, { ignore }).map((hit) => hit.body);
    expect(seen(body)).toEqual([other]);
    expect(seen(parts[1])).toEqual([other]);
    expect(seen(parts[0])).toEqual([parts[1], other]);
    expect(overlapShape(world, box(20, 1), {}, { ignore: body })).toEqual([other]);
    expect(nearestPoint(world, {}, { ignore: body })?.body).toBe(other);
    expect(castShape(world, box(0.1, 0.1), {}, { x: 9 }, { ignore: body })?.body).toBe(other);
  });

  test('leaves out a body, and layers', () => {
    const { world, ids } = worldWith([box(1, 1), 2, 0], [box(1, 1), 4, 0], [box(1, 1), 6, 0]);
    world.components.Collider.layers[ids[1]] = 4;
    const bodies = (filter = {}) => rayCastAll(world, { x: 0 }, { x: 9 }, filter).map(({ body }) => body);
    expect(bodies({ ignore: ids[0] })).toEqual([ids[1], ids[2]]);
    expect(bodies({ ignore: [ids[0], ids[2]] })).toEqual([ids[1]]);
    expect(bodies({ ignore: [] })).toEqual(ids);
    expect(() => bodies({ ignore: [ids[0], -1] })).toThrow(/ignore/);
    expect(() => bodies({ mask: ~4 })).toThrow(/~4 >>> 0/);
    expect(bodies({ mask: 4 })).toEqual([ids[1]]);
    expect(bodies({ mask: 1 })).toEqual([ids[0], ids[2]]);
    expect(overlapShape(world, box(20, 1), {}, { mask: 4 })).toEqual([ids[1]]);
    expect(nearestPoint(world, { x: 2 }, { mask: 4 })?.body).toBe(ids[1]);
  });
});

describe('a shape', () => {
  test('overlaps what it touches, in order of id', () => {
    const { world, ids } = worldWith([box(1, 1), 1, 0], [circle(0.5), 0, 2], [capsule(2, 0.2), 0, -1, Math.PI / 2]);
    expect(overlapShape(world, box(1, 1), {})).toEqual([ids[0], ids[2]]);
    expect(overlapShape(world, box(1, 4, { rounding: 0.1 }), { angle: 0.01 })).toEqual(ids);
    expect(overlapShape(world, circle(0.1), { x: 10 })).toEqual([]);
  });

  test('stops 0.1 mm before what it is cast at', () => {
    const { world, ids } = worldWith([box(1, 1), 5, 0], [circle(0.5), 8, 0]);
    const hits = castShapeAll(world, box(1, 1), { y: 0.2 }, { x: 10 });
    expect(hits.map(({ body }) => body)).toEqual(ids);
    expect(hits[0].fraction).toBeGreaterThan((4 - 1.3e-4) / 10);
    expect(hits[0].fraction).toBeLessThan(0.4);
    expect(hits[0]).toMatchObject({ nx: close(-1), ny: close(0), x: close(4.5, 3) });
    expect(castShape(world, box(1, 1), { y: 0.2 }, { x: 10 })).toEqual(hits[0]);
    expect(castShape(world, box(1, 1), { y: 1.1 }, { x: 10 })).toBeUndefined();
  });

  test('that overlaps a body at the start meets it at once', () => {
    const { world } = worldWith([box(1, 1), 0, 0]);
    expect(castShape(world, circle(0.5), { x: 0.9 }, { x: 5 })).toMatchObject({ fraction: 0, nx: close(1) });
  });
});

describe('the nearest point', () => {
  test('is on the side, the corner or the arc of a body', () => {
    const { world, ids } = worldWith([box(2, 1), 0, 0], [circle(1), 10, 0]);
    expect(nearestPoint(world, { x: 0.3, y: 2 })).toEqual({
      body: ids[0],
      isWall: false,
      distance: close(1.5),
      x: close(0.3),
      y: 0.5,
    });
    expect(nearestPoint(world, { x: 4, y: 4.5 })).toMatchObject({ distance: close(5), x: 1, y: 0.5 });
    expect(nearestPoint(world, { x: 10 + 3 * 0.6, y: 3 * 0.8 })).toMatchObject({ x: close(10.6), y: close(0.8) });
  });

  test('is the point itself inside a body', () => {
    const { world, ids } = worldWith([box(2, 1, { rounding: 0.2 }), 0, 0]);
    expect(nearestPoint(world, { x: 0.95, y: 0.1 })).toMatchObject({ body: ids[0], distance: 0, x: 0.95, y: 0.1 });
  });

  test('is none beyond the greatest distance', () => {
    const { world } = worldWith([box(2, 1), 0, 0]);
    expect(nearestPoint(world, { x: 3 }, { maxDistance: 1.99 })).toBeUndefined();
    expect(nearestPoint(world, { x: 3 }, { maxDistance: 2.01 })).toBeDefined();
  });
});

test('the body at a point is one whose shape contains it', () => {
  const corner = polygon([{ x: 0 }, { x: 1 }, { y: 1 }]);
  const { world, ids } = worldWith([corner, corner.centre.x, corner.centre.y], [box(1, 0.1), 0.5, 0.9, Math.PI / 2]);
  expect(bodyAt(world, { x: 0.2, y: 0.2 })).toBe(ids[0]);
  expect(bodyAt(world, { x: 0.56, y: 0.56 })).toBe(0);
  expect(bodyAt(world, { x: 0.56, y: 0.56 }, { margin: 0.1 })).not.toBe(0);
  expect(bodyAt(world, { x: 0.53, y: 1.3 })).toBe(ids[1]);
});

test.each([
  ['standard', standard],
  ['rigidBodies', rigidBodies],
])('a radius written beside a shape means nothing to queries, %s', (_, preset) => {
  const world = createPhysicsWorld({ preset, capacity: 1000 });
  const plank = spawn(world, { position: {}, collider: { shape: box(4, 0.2) } });
  world.components.Collider.radius[plank] = 0.01;
  // From above through the end of the plank, 1.9 m from its middle.
  const above = { x: 1.9, y: 3 };
  expect(rayCast(world, above, { x: 1.9, y: -3 })).toMatchObject({ body: plank, fraction: close((3 - 0.1) / 6) });
  expect(castShape(world, circle(0.1), above, { y: -6 })).toMatchObject({
    body: plank,
    fraction: close((3 - 0.2) / 6, 4),
  });
  expect(nearestPoint(world, { x: 1.9, y: 1 })).toMatchObject({ body: plank, distance: close(0.9) });
  expect(overlapShape(world, circle(0.1), { x: 1.9 })).toEqual([plank]);
  expect(bodyAt(world, { x: 1.9 })).toBe(plank);
});

test('queries refuse what they cannot answer', () => {
  const { world } = worldWith([box(1, 1), 0, 0]);
  const space = createPhysicsWorld({ dimensions: 3 });
  const codeOf = (ask: (world: PhysicsWorld) => unknown, where = world) => {
    try {
      return ask(where);
    } catch (error) {
      return error instanceof PhysicsError ? error.code : error;
    }
  };
  expect(codeOf((where) => rayCast(where, {}, { x: 1 }), space)).toBe('E_RANGE');
  expect(codeOf((where) => rayCast(where, { x: Number.NaN }, {}))).toBe('E_NONFINITE');
  expect(codeOf((where) => rayCast(where, {}, {}, { mask: -1 }))).toBe('E_RANGE');
  expect(codeOf((where) => rayCast(where, {}, {}, { masks: 1 } as never))).toBe('E_UNKNOWN');
  expect(codeOf((where) => overlapShape(where, 'box' as never, {}))).toBe('E_TYPE');
  expect(codeOf((where) => castShape(where, box(1, 1), { angles: 1 } as never, {}))).toBe('E_UNKNOWN');
  expect(codeOf((where) => nearestPoint(where, {}, { maxDistance: -1 }))).toBe('E_RANGE');
});
