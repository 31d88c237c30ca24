import { createPhysicsWorld, despawn, restore, snapshot, spawn, step } from '@principia/physics';
import { addComponent, query, removeComponent } from 'bitecs';
import { expect, it } from 'vitest';
import type { BodySource } from './body-source.ts';
import { worldSource } from './world-source.ts';

it('has never seen versions again after the world was brought back, though the world counts as it did', () => {
  const world = createPhysicsWorld();
  const { versions } = worldSource(world);
  const seen = new Set<string>();
  const play = () => {
    for (let i = 0; i < 5; i++) {
      seen.add(`pose ${versions.pose}`);
      seen.add(`membership ${versions.membership}`);
      spawn(world, { position: {}, velocity: {} });
      step(world, 1 / 60);
    }
  };
  const taken = snapshot(world);
  play();
  const { size } = seen;
  for (const turns of [2, 3]) {
    restore(world, taken);
    play();
    expect(seen.size).toBe(turns * size);
  }
});

const shown = ({ ids, count }: BodySource) => [...ids.subarray(0, count)];

it('has the bodies of a list, without those that are gone and without others that take their ids', () => {
  const world = createPhysicsWorld();
  const [a, b, c] = [0, 1, 2].map(() => spawn(world, { position: {} }));
  const source = worldSource(world, { bodies: [c, a] });
  expect(shown(source)).toEqual([a, c]);
  const { membership } = source.versions;
  expect(source.versions.membership).toBe(membership);
  const taken = snapshot(world);
  despawn(world, a);
  expect(spawn(world, { position: {} })).toBe(a);
  expect(shown(source)).toEqual([c]);
  expect(source.versions.membership).toBeGreaterThan(membership);
  expect(shown(worldSource(world))).toEqual([a, b, c]);
  restore(world, taken);
  expect(shown(source)).toEqual([a, c]);
});

it('has the bodies of a query, as they come and go', () => {
  const world = createPhysicsWorld();
  const Hero = {};
  const [a, b] = [0, 1].map(() => spawn(world, { position: {} }));
  const source = worldSource(world, { bodies: () => query(world, [Hero]) });
  expect(shown(source)).toEqual([]);
  let { membership } = source.versions;
  addComponent(world, b, Hero);
  addComponent(world, a, Hero);
  expect(source.versions.membership).toBeGreaterThan(membership);
  expect(shown(source)).toEqual([a, b]);
  ({ membership } = source.versions);
  removeComponent(world, b, Hero);
  expect(source.versions.membership).toBeGreaterThan(membership);
  expect(shown(source)).toEqual([a]);
});

it('refuses ids and options that do not exist', () => {
  const world = createPhysicsWorld();
  expect(() => worldSource(world, { bodies: [1, -2] })).toThrow('bodies[1] must be an entity id from 1 to');
  expect(() => worldSource(world, { body: [1] } as object)).toThrow('body');
});
