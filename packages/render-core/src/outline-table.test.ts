import { box, createPhysicsWorld, despawn, restore, shapeAt, snapshot, spawn } from '@principia/physics';
import { expect, test } from 'vitest';
import { OUTLINE_TEXELS } from './body-source.ts';
import { OutlineTable } from './outline-table.ts';

test('outlines are those of the shapes, also where one took the place of another', () => {
  const world = createPhysicsWorld();
  const { Collider } = world.components;
  const table = new OutlineTable();
  const spawnBox = (width: number) => spawn(world, { position: {}, collider: { shape: box(width, 1) } });
  const expectOutline = (id: number) => {
    const { texels } = table.refresh(world);
    const at = Collider.shape[id] * OUTLINE_TEXELS;
    const { vertices = [] } = shapeAt(world, Collider.shape[id]) ?? {};
    expect([...texels.slice(at + 4, at + 4 + vertices.length)]).toEqual(vertices.map(Math.fround));
  };
  const taken = snapshot(world);
  for (let i = 1; i < 700; i++) {
    const id = spawnBox(i);
    expectOutline(id);
    despawn(world, id);
  }
  restore(world, taken);
  expectOutline(spawnBox(0.7));
});

test('the version changes with the outlines alone', () => {
  const world = createPhysicsWorld();
  const table = new OutlineTable();
  spawn(world, { position: {}, collider: { shape: box(1, 1) } });
  const { version } = table.refresh(world);
  spawn(world, { position: {}, collider: { shape: box(1, 1) } });
  expect(table.refresh(world).version).toBe(version);
  spawn(world, { position: {}, collider: { shape: box(2, 1) } });
  expect(table.refresh(world).version).toBeGreaterThan(version);
});
