import { describe, expect, test } from 'vitest';
import { createPhysicsWorld, particleContacts } from '../index.ts';
import { ContactTableWord } from '../memory/layouts.gen.ts';
import { contactTable } from './contact-table.ts';

describe.each([
  [2, 'f32'],
  [2, 'f64'],
  [3, 'f32'],
  [3, 'f64'],
] as const)('the memory of contacts in %d D, %s', (dimensions, precision) => {
  test.each([1, 1000, 20_000])(
    'holds a dense packing of %d bodies and leaves half a KiB per body to other features',
    (capacity) => {
      const world = createPhysicsWorld({ preset: particleContacts, dimensions, precision, capacity });
      const { arena } = world.internal;
      expect(contactTable(world).words[ContactTableWord.capacity]).toBeGreaterThanOrEqual(
        (dimensions === 2 ? 4 : 8) * capacity,
      );
      expect(arena.bytes - arena.top).toBeGreaterThan(200 * capacity);
    },
  );
});
