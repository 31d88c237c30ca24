import { describe, expect, test } from 'vitest';
import {
  boxWalls,
  contactCapacity,
  contacts,
  createPhysicsWorld,
  createRandom,
  despawn,
  on,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  particleContacts,
  spawn,
  spawnMany,
  standard,
  step,
  wallContacts,
} from '../index.ts';

const make = (options: PhysicsWorldOptions = {}) =>
  createPhysicsWorld({ preset: particleContacts, capacity: 2000, ...options });

const pair = (world: PhysicsWorld, mass: number) => {
  const b = spawn(world, { position: { x: 2.1 }, velocity: { x: -3 }, mass, collider: { radius: 1, restitution: 1 } });
  const a = spawn(world, { position: {}, velocity: { x: 3 }, mass, collider: { radius: 1, restitution: 1 } });
  return { a, b };
};

describe.each(['f32', 'f64'] as const)('the contacts of a step, %s', (precision) => {
  test('list the pair by ascending id, the point, the normal and the impulse', () => {
    const world = make({ precision });
    const { a, b } = pair(world, 2);
    const found = contacts(world);
    expect(found.count).toBe(0);
    step(world, 0.02);
    expect(contacts(world)).toBe(found);
    expect(found.count).toBe(1);
    // b was created first.
    expect([found.a[0], found.b[0]]).toEqual([b, a]);
    expect(found.nx[0]).toBeCloseTo(-1, 6);
    expect([found.ny[0], found.nz[0], found.z[0]].map(Math.abs)).toEqual([0, 0, 0]);
    expect(found.x[0]).toBeCloseTo(1.05, 6);
    // Each body of 2 kg changes from 3 m/s to -3 m/s.
    expect(found.impulse[0]).toBeCloseTo(12, 5);
    expect(found.droppedCount).toBe(0);
    step(world, 0.02);
    expect(found.count).toBe(0);
  });

  test('are sorted by both ids', () => {
    const world = make({ precision });
    const random = createRandom(1);
    const uniform = () => Float64Array.from({ length: 500 }, () => random.uniform(0, 20));
    spawnMany(world, 500, { position: { x: uniform(), y: uniform() }, velocity: {}, mass: 1, collider: 0.6 });
    step(world, 0.01);
    const { count, a, b } = contacts(world);
    expect(count).toBeGreaterThan(300);
    for (let i = 0; i < count; i++) {
      expect(a[i]).toBeLessThan(b[i]);
      if (i > 0) expect(a[i] > a[i - 1] || (a[i] === a[i - 1] && b[i] > b[i - 1])).toBe(true);
    }
  });

  test('with walls list the wall, 0 for a box', () => {
    const world = make({ precision, walls: [boxWalls({ min: { x: -10 } })] });
    const wall = spawn(world, { segmentWall: { ax: -5, ay: 0, bx: 5, by: 0 } });
    const plane = spawn(world, { planeWall: { nx: -1, ny: 0, offset: -10 } });
    const moving = (x: number, y: number, vx: number, vy: number) =>
      spawn(world, {
        position: { x, y },
        velocity: { x: vx, y: vy },
        mass: 2,
        collider: { radius: 1, restitution: 0.5 },
      });
    const ids = [moving(0, 1.05, 0, -4), moving(-8.95, 50, -4, 0), moving(8.95, 20, 4, 0)];
    step(world, 0.02);
    const found = wallContacts(world);
    const byBody = new Map(Array.from({ length: found.count }, (_, i) => [found.body[i], i]));
    expect(found.count).toBe(3);
    ids.forEach((id, k) => {
      const i = byBody.get(id) as number;
      expect(found.wall[i]).toBe([wall, 0, plane][k]);
      expect([found.nx[i] + 0, found.ny[i] + 0, found.nz[i] + 0]).toEqual(
        [
          [0, 1, 0],
          [1, 0, 0],
          [-1, 0, 0],
        ][k],
      );
      expect(found.impulse[i]).toBeCloseTo(2 * 4 * 1.5, 5);
    });
    step(world, 0.02);
    expect(found.count).toBe(0);
  });
});

test('handlers receive the index of each contact, and may remove a body', () => {
  const world = make();
  const { a, b } = pair(world, 1);
  const heard: number[][] = [];
  const stop = on(world, 'contact', (i, of) => {
    const { a: first, b: second, impulse } = contacts(of);
    heard.push([first[i], second[i], impulse[i]]);
    despawn(of, second[i]);
  });
  step(world, 0.02);
  expect(heard).toEqual([[b, a, 6]]);
  expect(world.lastId).toBe(b);
  stop();
  spawn(world, { position: world.components.Position.x[b] === 0 ? {} : { x: 2 }, mass: 1, velocity: {}, collider: 1 });
  step(world, 0.02);
  expect(heard.length).toBe(1);
});

test('a world without contacts has none, and its walls keep no record', () => {
  const world = createPhysicsWorld({ preset: standard, walls: [boxWalls({ min: { y: 0 } })] });
  spawn(world, { position: { y: 0.5 }, velocity: { y: -1 }, mass: 1, collider: 1 });
  expect(contacts(world).count).toBe(0);
  step(world, 0.1);
  expect(wallContacts(world).count).toBe(0);
});

test('contacts beyond the capacity are counted, and arenaBytes sets the capacity', () => {
  const crowd = (arenaBytes?: number) => {
    const world = make({ capacity: 5000, ...(arenaBytes === undefined ? {} : { arenaBytes }) });
    spawnMany(world, 5000, { position: {}, velocity: {}, mass: 1, collider: 1 });
    step(world, 0.01);
    return world;
  };
  const usual = crowd();
  expect(contacts(usual).count + contacts(usual).droppedCount).toBeLessThanOrEqual((5000 * 4999) / 2);
  expect(contacts(usual).droppedCount).toBeGreaterThan(0);
  expect(contactCapacity(usual)).toBeGreaterThanOrEqual(4 * 5000);
  const small = crowd(2 ** 21);
  expect(contactCapacity(small)).toBeLessThan(contactCapacity(usual));
  expect(() => make({ capacity: 5000, arenaBytes: 2 ** 16 })).toThrow(expect.objectContaining({ code: 'E_CAPACITY' }));
});
