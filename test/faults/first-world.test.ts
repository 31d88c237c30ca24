/** The first world of a program treats ids as every other does. This file makes its first world itself. */
import { createPhysicsWorld, type EntityRef, entityRef, isAlive, rigidBodies, spawn } from '@principia/physics';
import { expect, it } from 'vitest';

it.each(['first', 'second'])('isAlive of an id is false, with a warning, in the %s world', () => {
  const warnings: string[] = [];
  const world = createPhysicsWorld({
    preset: rigidBodies,
    capacity: 10,
    onWarning: ({ message }) => warnings.push(message),
  });
  const id = spawn(world, { position: {}, collider: { radius: 1, density: 1 } });
  expect(isAlive(world, entityRef(world, id))).toBe(true);
  expect(warnings).toEqual([]);
  expect(isAlive(world, id as unknown as EntityRef)).toBe(false);
  expect(warnings).toEqual([`isAlive got ${id}, which is the id of a body, and not a reference of this world.`]);
});
