import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { faultsTable, MISSING, numbered } from './faults-page.ts';
import { withMarkedPart } from './marked-table.ts';

const page = readFileSync('docs/faults.md', 'utf8');

test('docs/faults.md lists the cases that tests hold; `npx vitest run test/docs/faults.test.ts -u` writes it', async () => {
  await expect(withMarkedPart(page, faultsTable())).toMatchFileSnapshot('../../docs/faults.md');
});

test('each of the 88 cases has a test or is named as missing', () => {
  const held = new Set(numbered.map(({ number }) => Number(number)));
  for (const [first, last] of MISSING) for (let n = first; n <= last; n++) held.add(n);
  expect([...held].sort((a, b) => a - b)).toEqual(Array.from({ length: 88 }, (_, i) => i + 1));
});
