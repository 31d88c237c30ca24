// Shapes that nothing has give their records to later ones: a world needs room for the shapes of its bodies alone.
import { addComponent, addEntity, addPrefab, IsA, observe, onAdd, set } from 'bitecs';
import { describe, expect, test } from 'vitest';
import {
  box,
  createPhysicsWorld,
  despawn,
  encodeSnapshot,
  type PhysicsWorld,
  restore,
  rigidBodies,
  setShape,
  shapeAt,
  shapeCount,
  snapshot,
  spawn,
  spawnMany,
  stateHash,
  step,
} from '../../index.ts';

/** Records that a pool has at first. */
const FIRST_CAPACITY = 256;

const widthOf = (world: PhysicsWorld, id: number) => {
  const vertices = shapeAt(world, world.components.Collider.shape[id])?.vertices ?? [];
  return Math.max(...vertices.filter((_, i) => i % 2 === 0)) * 2;
};

const spawnBox = (world: PhysicsWorld, width: number) =>
  spawn(world, { position: {}, collider: { shape: box(width, 1) } });

/** Gives one body after another a new shape, and removes it. */
function churn(world: PhysicsWorld, count: number, first = 1000): void {
  for (let i = 0; i < count; i++) despawn(world, spawnBox(world, first + i));
}

test('5 000 shapes that come and go need no more room than a few', () => {
  const world = createPhysicsWorld({ capacity: 50 });
  const kept = spawnBox(world, 3);
  churn(world, 600);
  const bytes = encodeSnapshot(snapshot(world)).length;
  churn(world, 5000);
  expect(shapeCount(world)).toBeLessThanOrEqual(FIRST_CAPACITY);
  expect(encodeSnapshot(snapshot(world)).length).toBeLessThan(1.5 * bytes);
  expect(widthOf(world, kept)).toBe(3);
});

test('bodies keep their shapes, more than there was room for at first', () => {
  const world = createPhysicsWorld();
  const ids = Array.from({ length: 600 }, (_, i) => spawnBox(world, i + 1));
  for (const id of ids.filter((id) => id % 3 > 0)) despawn(world, id);
  churn(world, 2000);
  for (const id of ids.filter((id) => id % 3 === 0)) expect(widthOf(world, id)).toBe(ids.indexOf(id) + 1);
});

test('a body whose shape changes for ever keeps the last one', () => {
  const world = createPhysicsWorld();
  const body = spawnBox(world, 1);
  for (let i = 2; i < 1000; i++) {
    setShape(world, body, box(i, 1));
    expect(widthOf(world, body)).toBe(i);
  }
});

describe('bodies that are not there yet keep their shapes:', () => {
  test('those spawned within steps', () => {
    const world = createPhysicsWorld({ capacity: 2000 });
    const widths = new Map<number, number>();
    let width = 1;
    world.phases.input.push((w) => {
      for (let i = 0; i < 300; i++) widths.set(spawnBox(w, ++width), width);
    });
    for (let i = 0; i < 20; i++) {
      step(world, 0.01);
      for (const [id, expected] of widths) expect(widthOf(world, id)).toBe(expected);
      for (const id of widths.keys()) despawn(world, id);
      widths.clear();
    }
    expect(shapeCount(world)).toBeLessThan(1024);
  });

  test('one whose observers spawn others', () => {
    const world = createPhysicsWorld({ capacity: 2000 });
    let isBusy = false;
    observe(world, onAdd(world.components.Position), () => {
      if (isBusy) return;
      isBusy = true;
      churn(world, 300);
      const other = spawnBox(world, 9);
      setShape(world, other, box(8, 1));
      churn(world, 300, 5000);
      isBusy = false;
    });
    for (let i = 0; i < 5; i++) expect(widthOf(world, spawnBox(world, 20 + i))).toBe(20 + i);
    const [first] = spawnMany(world, 2, { position: {}, collider: { shape: box(7, 1) } });
    expect(widthOf(world, first)).toBe(7);
  });

  test('instances of a prefab', () => {
    const world = createPhysicsWorld();
    const { Position, Collider } = world.components;
    const prefab = addPrefab(world);
    const model = spawnBox(world, 5);
    addComponent(world, prefab, set(Position, {}));
    addComponent(world, prefab, set(Collider, { shape: Collider.shape[model], radius: 3 }));
    despawn(world, model);
    churn(world, 1000);
    const instance = addEntity(world);
    addComponent(world, instance, IsA(prefab));
    expect(widthOf(world, instance)).toBe(5);
  });
});

test('a world that is brought back has its shapes, and goes on to the bit', () => {
  const make = () => createPhysicsWorld({ preset: rigidBodies });
  const [world, other] = [make(), make()];
  for (const each of [world, other]) {
    churn(each, 100);
    for (let i = 0; i < 100; i++) spawnBox(each, i + 2);
  }
  const taken = snapshot(world);
  for (let i = 1; i <= 100; i++) despawn(world, i);
  churn(world, 500, 9000);
  restore(world, taken);
  for (const each of [world, other]) {
    churn(each, 300, 7000);
    spawnBox(each, 0.5);
    step(each, 0.01);
  }
  expect(stateHash(world)).toBe(stateHash(other));
  expect(widthOf(world, 50)).toBe(51);
});

test('shapes that no body has do not count in the hash', () => {
  const [world, other] = [createPhysicsWorld(), createPhysicsWorld()];
  for (const each of [world, other]) spawnBox(each, 1);
  churn(world, 3);
  expect(stateHash(world)).toBe(stateHash(other));
  const before = stateHash(world);
  stateHash(world);
  expect(stateHash(world)).toBe(before);
  expect(shapeCount(world)).toBe(5);
});
