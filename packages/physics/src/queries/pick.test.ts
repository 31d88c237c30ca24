import { expect, test } from 'vitest';
import { box, despawn, type PhysicsWorld, rigidBodies, spawn, spawnCompound, step } from '../index.ts';
import { createPhysicsWorld, destroyWorld } from '../world/create-world.ts';
import { bodyAt } from './pick.ts';

const centreOf = ({ components: { Position } }: PhysicsWorld, id: number) => ({
  x: Position.x[id] as number,
  y: Position.y[id] as number,
});

test('picks the nearest of the bodies that hold the point, before any step and after', () => {
  const world = createPhysicsWorld();
  const large = spawn(world, { position: {}, collider: 5 });
  const small = spawn(world, { position: { x: 2 }, collider: 1 });
  for (let turn = 0; turn < 2; turn++) {
    expect(bodyAt(world, { x: 2.4 })).toBe(small);
    expect(bodyAt(world, { x: -4.9 })).toBe(large);
    expect(bodyAt(world, { x: -5.1 })).toBe(0);
    expect(bodyAt(world, { x: -5.1 }, { margin: 0.2 })).toBe(large);
    step(world, 0.01);
  }
  despawn(world, small);
  expect(bodyAt(world, { x: 2.4 })).toBe(large);
});

test('a body without collider is picked by its drawn size, and of two as near the one with the smaller id wins', () => {
  const world = createPhysicsWorld();
  const drawn = spawn(world, { position: { x: 1 }, appearance: { size: 0.5 } });
  spawn(world, { position: { x: 1 }, appearance: { size: 0.5 } });
  expect(bodyAt(world, { x: 1.4 })).toBe(drawn);
  expect(bodyAt(world, { x: 1.6 })).toBe(0);
});

test('depth counts in 3D alone', () => {
  const flat = createPhysicsWorld();
  const disc = spawn(flat, { position: {}, collider: 1 });
  expect(bodyAt(flat, { z: 9 })).toBe(disc);
  const deep = createPhysicsWorld({ dimensions: 3 });
  const ball = spawn(deep, { position: { z: 8.5 }, collider: 1 });
  expect(bodyAt(deep, { z: 9 })).toBe(ball);
  expect(bodyAt(deep, { z: 7 })).toBe(0);
});

test('sensors, layers and bodies can be left out', () => {
  const world = createPhysicsWorld();
  const crate = spawn(world, { position: { x: 0.5 }, collider: { radius: 1, layers: 2 } });
  const area = spawn(world, { position: {}, collider: { radius: 5, sensor: true } });
  const drawn = spawn(world, { position: { x: 0.7 }, appearance: { size: 2 } });
  const at = (options = {}) => bodyAt(world, { x: 0.1 }, options);
  expect(at()).toBe(crate);
  expect(at({ sensors: true })).toBe(area);
  expect(at({ mask: 1 })).toBe(drawn);
  expect(at({ ignore: crate })).toBe(drawn);
  expect(at({ ignore: [crate, drawn] })).toBe(0);
  expect(() => at({ mask: -1 })).toThrow(/E_RANGE/);
});

test('of a compound body the parts are picked, and nothing in its hollow', () => {
  const world = createPhysicsWorld({ preset: rigidBodies });
  const { body, parts } = spawnCompound(world, {
    parts: [
      { shape: box(4, 0.2), y: -1, density: 1 },
      { shape: box(0.2, 4), x: -2, y: 1, density: 1 },
      { shape: box(0.2, 4), x: 2, y: 1, density: 1 },
    ],
  });
  const { x, y } = centreOf(world, body);
  expect(bodyAt(world, { x, y })).toBe(0);
  expect(bodyAt(world, { x, y }, { margin: 0.3 })).toBe(0);
  // The bottom is 1.33 m below the centre of mass, of three bars of the same mass at y = -1, 1 and 1; the sides are 2 m away, and their
  // centres further than its own.
  expect(bodyAt(world, { x, y }, { margin: 2 })).toBe(parts[0]);
});

test('rejects invalid points and margins, and destroyed worlds', () => {
  const world = createPhysicsWorld();
  expect(() => bodyAt(world, { x: NaN })).toThrow(expect.objectContaining({ code: 'E_NONFINITE' }));
  expect(() => bodyAt(world, { w: 1 } as never)).toThrow(expect.objectContaining({ code: 'E_UNKNOWN' }));
  expect(() => bodyAt(world, {}, { margin: -1 })).toThrow(expect.objectContaining({ code: 'E_RANGE' }));
  expect(() => bodyAt(world, {}, { radius: 1 } as never)).toThrow(expect.objectContaining({ code: 'E_UNKNOWN' }));
  destroyWorld(world);
  expect(() => bodyAt(world, {})).toThrow(expect.objectContaining({ code: 'E_DESTROYED' }));
});
