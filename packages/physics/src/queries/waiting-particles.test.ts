import { removeEntity } from 'bitecs';
import { expect, test } from 'vitest';
import {
  box,
  burst,
  createEmitter,
  createPhysicsWorld,
  destroyEmitter,
  type EmitterOptions,
  nearestPoint,
  overlapShape,
  pairsWithin,
  rayCast,
  restore,
  snapshot,
  spawn,
  step,
} from '../index.ts';
import { bodyAt } from './pick.ts';

/** Three bodies 5 m apart on the x axis, none at the origin, and an emitter there of particles that live for 1 s. */
function bodiesAndPool(options: Partial<EmitterOptions> = {}, capacity = 50) {
  const world = createPhysicsWorld({ capacity: capacity + 10 });
  const three = [5, 10, 15].map((x) => spawn(world, { position: { x }, velocity: {}, mass: 1, collider: 0.5 }));
  const emitter = createEmitter(world, { capacity, lifetime: 1, speed: 0, ...options });
  return { world, three, emitter };
}

test('particles that wait make no pairs: none in a pool of 5000, and then those of the living', () => {
  const { world, emitter } = bodiesAndPool({}, 5000);
  expect(pairsWithin(world, 1).count).toBe(0);
  expect(pairsWithin(world, 1, emitter.ids).count).toBe(0);
  expect(pairsWithin(world, 5).count).toBe(2);
  burst(emitter, 20);
  step(world, 1 / 60);
  // All twenty are at the origin.
  expect(pairsWithin(world, 1).count).toBe((20 * 19) / 2);
  expect(pairsWithin(world, 1, emitter.ids).count).toBe((20 * 19) / 2);
  for (let i = 0; i < 61; i++) step(world, 1 / 60);
  expect(pairsWithin(world, 1).count).toBe(0);
});

test('a particle is picked while it lives', () => {
  const { world, three, emitter } = bodiesAndPool({ size: 0.1 });
  expect(bodyAt(world, {})).toBe(0);
  expect(bodyAt(world, { x: 0.2 }, { margin: 0.3 })).toBe(0);
  expect(bodyAt(world, { x: 4.6 })).toBe(three[0]);
  burst(emitter, 1);
  step(world, 1 / 60);
  expect(emitter.ids).toContain(bodyAt(world, { x: 0.2 }, { margin: 0.3 }));
  for (let i = 0; i < 61; i++) step(world, 1 / 60);
  expect(bodyAt(world, { x: 0.2 }, { margin: 0.3 })).toBe(0);
});

test('rays and shapes meet a particle with a collider while it lives', () => {
  const { world, three, emitter } = bodiesAndPool({ collider: { radius: 0.1 } });
  const metNear = () => ({
    overlapping: overlapShape(world, box(1, 1), {}).length,
    nearest: nearestPoint(world, { x: 1 })?.body,
    hit: rayCast(world, { x: -3 }, { x: 3 })?.x,
  });
  const nothing = { overlapping: 0, nearest: three[0], hit: undefined };
  expect(metNear()).toEqual(nothing);
  burst(emitter, 2);
  step(world, 1 / 60);
  expect(metNear()).toEqual({ overlapping: 2, nearest: emitter.ids[0], hit: expect.closeTo(-0.1, 9) });
  for (let i = 0; i < 61; i++) step(world, 1 / 60);
  expect(metNear()).toEqual(nothing);
});

test('a body in the row of a particle that was removed through bitECS counts, and the rows of a destroyed emitter are free', () => {
  const { world, emitter } = bodiesAndPool();
  removeEntity(world, emitter.ids[0]);
  const heir = spawn(world, { position: {}, velocity: {}, mass: 1, collider: 0.5 });
  expect(heir).toBe(emitter.ids[0]);
  expect(bodyAt(world, { x: 0.4 })).toBe(heir);
  spawn(world, { position: { x: 0.5 } });
  expect(pairsWithin(world, 1).count).toBe(1);
  destroyEmitter(emitter);
  expect(pairsWithin(world, 1).count).toBe(1);
  for (let i = 0; i < 50; i++) spawn(world, { position: { x: 1000 } });
  expect(pairsWithin(world, 1).count).toBe(1 + (50 * 49) / 2);
});

test('a restored world has the living particles of its moment', () => {
  const { world, emitter } = bodiesAndPool();
  const before = snapshot(world);
  burst(emitter, 3);
  step(world, 1 / 60);
  const after = snapshot(world);
  restore(world, before);
  expect(pairsWithin(world, 1).count).toBe(0);
  restore(world, after);
  expect(pairsWithin(world, 1).count).toBe(3);
});
