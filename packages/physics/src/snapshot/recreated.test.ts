// Entities that a restore creates again: what bitECS, its queries and its observers know of them afterwards.
import { getEntityComponents, hasComponent, Not, observe, onAdd, query } from 'bitecs';
import { expect, test } from 'vitest';
import {
  box,
  createPhysicsWorld,
  defineComponent,
  despawn,
  realField,
  restore,
  rigidBodies,
  snapshot,
  spawn,
  spawnCompound,
  stateHash,
  step,
} from '../index.ts';

const Heat = defineComponent({ fields: { value: realField('K') } });

function crowd() {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 200, components: [Heat] });
  const ids = [
    spawn(world, { position: { x: 1 }, velocity: { y: 2 }, mass: 3 }),
    spawn(world, { position: { x: 5 }, collider: { shape: box(1, 1), density: 2 }, neverSleep: {} }),
    spawn(world, { planeWall: { ny: 1, offset: -5 } }),
    spawn(world, { position: { x: 9 }, velocity: {}, mass: 1 }),
  ];
  const { body, parts } = spawnCompound(world, { position: { y: 9 }, parts: [{ radius: 1, density: 1 }] });
  return { world, ids, body, all: [...ids, body, ...parts] };
}

test('they have their components, and are in the queries that they belong to', () => {
  const { world, ids, body, all } = crowd();
  const { Position, Mass, Collider } = world.components;
  const known = () => ({
    components: all.map((id) => new Set(getEntityComponents(world, id))),
    masses: [...query(world, [Position, Mass])].sort(),
    bare: [...query(world, [Position, Not(Collider)])].sort(),
    hash: stateHash(world),
  });
  const before = known();
  const taken = snapshot(world);
  for (const id of [...ids, body]) despawn(world, id);
  expect(query(world, [Position]).length).toBe(0);
  restore(world, taken);
  expect(known()).toEqual(before);
  expect(all.map((id) => hasComponent(world, id, Position))).toEqual(
    all.map((id) => before.components[all.indexOf(id)].has(Position)),
  );
  for (let i = 0; i < 10; i++) step(world, 0.01);
  const twin = crowd().world;
  for (let i = 0; i < 10; i++) step(twin, 0.01);
  expect(stateHash(world)).toBe(stateHash(twin));
});

test('observers hear of each once, when it has all its components, and one that throws hinders none', () => {
  const { world, ids } = crowd();
  const { Position, Mass, Velocity } = world.components;
  const taken = snapshot(world);
  despawn(world, ids[0]);
  despawn(world, ids[3]);
  const heard: number[] = [];
  observe(world, onAdd(Position, Mass), (id: number) => {
    expect(hasComponent(world, id, Velocity)).toBe(true);
    heard.push(id);
    throw new Error(`observer of ${id}`);
  });
  const hash = stateHash(crowd().world);
  expect(() => restore(world, taken)).toThrow(/observers threw 2/);
  expect(heard.sort()).toEqual([ids[0], ids[3]]);
  expect(stateHash(world)).toBe(hash);
});
