import { existsSync, readFileSync } from 'node:fs';
import { INTEGRATORS } from '@principia/physics';
import { expect, test } from 'vitest';
import { withTable } from '../../scripts/lib/integrators-table.mjs';

const page = readFileSync('docs/integrators.md', 'utf8');

test('the table of integrators is the one that their records make (node scripts/integrators-page.mjs)', () => {
  expect(withTable(page, INTEGRATORS)).toBe(page);
});

test('the picture is there', () => {
  expect(existsSync('docs/images/integrators.svg')).toBe(true);
  expect(readFileSync('docs/images/integrators.svg', 'utf8')).toContain('Gauss-Radau');
});

test('names are unique, and every record is of the scheme it creates', () => {
  const records = Object.values(INTEGRATORS);
  expect(new Set(records.map(({ name }) => name)).size).toBe(records.length);
  for (const record of records) {
    const { name, order, symplectic } = record.create();
    expect({ name, order, symplectic }).toEqual({
      name: record.name,
      order: record.order,
      symplectic: record.symplectic,
    });
  }
});
