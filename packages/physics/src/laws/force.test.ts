import {
  applyImpulse,
  createPhysicsWorld,
  defineForce,
  entityRef,
  type PhysicsWorld,
  resolve,
  spawn,
} from '@principia/physics';
import { expect, test } from 'vitest';

test('a force of one’s own that reads an unknown component is refused, by its name', () => {
  const make = (more: object) => () => defineForce({ name: 'push', accumulate() {}, ...more });
  expect(make({ reads: ['Positions'] })).toThrow(/E_UNKNOWN.*no component "Positions".*Position/);
  expect(make({ local: false, readsOfOthers: ['Charges'] })).toThrow(/E_UNKNOWN.*"Charges"/);
  expect(make({ reads: 'Position' })).toThrow(/E_TYPE.*reads/);
  expect(make({ reads: ['Position', 'Charge'] })().reads).toEqual(['Position', 'Charge']);
});

test('a function that gets a reference in place of an id says so', () => {
  // The references of the first world of a program may be its ids.
  const [, world] = [1, 2].map(() => createPhysicsWorld({ capacity: 10 })) as [PhysicsWorld, PhysicsWorld];
  const id = spawn(world, { position: {}, velocity: {}, mass: 1 });
  const ref = entityRef(world, id);
  expect(() => applyImpulse(world, ref, { x: 1 })).toThrow(/E_STALE.*resolve\(world, ref\)/);
  applyImpulse(world, resolve(world, ref), { x: 1 });
  expect(world.components.Velocity.x[id]).toBe(1);
});
