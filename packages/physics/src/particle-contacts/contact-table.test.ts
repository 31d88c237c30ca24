import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { createPhysicsWorld, particleContacts } from '../index.ts';
import * as columnTable from '../memory/column-table.ts';
import * as contactTables from './contact-table.ts';
import { contactTable, Word } from './contact-table.ts';

/** Returns the fields of an `@unmanaged` class in the kernels, in order. */
function fieldsOf(file: string, name: string): string[] {
  const source = readFileSync(new URL(`../../kernels/${file}`, import.meta.url), 'utf8');
  const body = source.slice(source.indexOf(`class ${name} {`)).split('\n}')[0];
  return [...body.matchAll(/^ {2}(\w+): \w+;/gm)].map((match) => match[1]);
}

/**
 * Returns the members of an enumeration before its `end`, in order. A const enum is an object where files are compiled
 * separately, as here.
 */
function namesOf(file: object, enumeration: string): string[] {
  const words = (file as Readonly<Record<string, object>>)[enumeration];
  return Object.keys(words).filter((name) => name !== 'end' && Number.isNaN(Number(name)));
}

test('the table layouts match the kernels', () => {
  expect(fieldsOf('particle-contacts/table.ts', 'ContactTable')).toEqual([
    'previousDt',
    ...namesOf(contactTables, 'Word'),
  ]);
  expect(fieldsOf('memory/columns.ts', 'Columns')).toEqual(namesOf(columnTable, 'TableColumn'));
});

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
      expect(contactTable(world).words[Word.capacity]).toBeGreaterThanOrEqual((dimensions === 2 ? 4 : 8) * capacity);
      expect(arena.bytes - arena.top).toBeGreaterThan(200 * capacity);
    },
  );
});
