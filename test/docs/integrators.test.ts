import { readFileSync } from 'node:fs';
import * as physics from '@principia/physics';
import { INTEGRATORS, type IntegratorName } from '@principia/physics';
import { expect, test } from 'vitest';
import { PANELS } from '../../scripts/lib/energy-panels.mjs';
import { withTable } from '../../scripts/lib/integrators-table.mjs';

const page = readFileSync('docs/integrators.md', 'utf8');

test('the table of integrators is the one that their records make (node scripts/integrators-page.mjs)', () => {
  expect(withTable(page, INTEGRATORS)).toBe(page);
});

test('the picture shows every scheme, each in one panel (node scripts/integrators-page.mjs --picture)', () => {
  const shown = PANELS.flatMap(({ schemes }) => schemes);
  expect(shown.toSorted(), 'each scheme is in one panel of scripts/lib/energy-panels.mjs').toEqual(
    Object.keys(INTEGRATORS).toSorted(),
  );
  const panels = readFileSync('docs/images/integrators.svg', 'utf8').split('<g ').slice(1);
  expect(panels.length).toBe(PANELS.length);
  PANELS.forEach(({ schemes, beside }, i) => {
    for (const key of [...schemes, ...beside]) {
      expect(panels[i]).toContain(`data-scheme="${key}"`);
      expect(panels[i]).toContain(`>${INTEGRATORS[key as IntegratorName].name}</text>`);
    }
  });
});

test('every scheme can be imported by the name in the table: packages/physics/src/index.ts exports it', () => {
  for (const [key, { code }] of Object.entries(INTEGRATORS)) {
    expect(code.match(/^\w+/)?.[0], 'the code of a record begins with its name').toBe(key);
    expect(Object.keys(physics), `export { ${key} } in packages/physics/src/index.ts`).toContain(key);
  }
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
