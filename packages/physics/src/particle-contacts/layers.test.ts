import { expect, test } from 'vitest';
import { contacts, createPhysicsWorld, particleContacts, spawn, step } from '../index.ts';

const ALL = 0xffffffff;

/** Whether two discs that overlap, on these layers and with these masks, touch. */
function touch(a: { layers: number; mask: number }, b: { layers: number; mask: number }): boolean {
  const world = createPhysicsWorld({ preset: particleContacts, capacity: 10 });
  [a, b].forEach((layers, i) => {
    spawn(world, { position: { x: 0.9 * i }, mass: 1, collider: { radius: 0.5, ...layers } });
  });
  step(world, 0.01);
  return contacts(world).count === 1;
}

test.each([
  [{ layers: 1, mask: ALL }, { layers: 1, mask: ALL }, true],
  [{ layers: 1, mask: ALL }, { layers: 2, mask: ALL }, true],
  [{ layers: 1, mask: 2 }, { layers: 2, mask: 1 }, true],
  // Bodies of one layer that its mask leaves out, such as the exhaust of a rocket.
  [{ layers: 4, mask: 3 }, { layers: 4, mask: 3 }, false],
  // It takes both: a ship that ignores its exhaust is not touched by it.
  [{ layers: 1, mask: 1 }, { layers: 4, mask: ALL }, false],
  [{ layers: 4, mask: ALL }, { layers: 1, mask: 1 }, false],
  // The uppermost bit is one of them.
  [{ layers: 2 ** 31, mask: 2 ** 31 }, { layers: 2 ** 31, mask: 2 ** 31 }, true],
])('layers and masks of both decide: %o, %o', (a, b, expected) => {
  expect(touch(a, b)).toBe(expected);
  expect(touch(b, a)).toBe(expected);
});
