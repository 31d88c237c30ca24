import { readdirSync, readFileSync } from 'node:fs';
import * as physics from '@principia/physics';
import { expect, test } from 'vitest';
import { manifestOf, packageNames } from '../../scripts/lib/packages.mjs';

const text = readFileSync('CHANGELOG.md', 'utf8');

test('the changelog begins with the version of every package, and its date', () => {
  const [, version] = /^## \[(\S+)\] - \d{4}-\d\d-\d\d$/m.exec(text) ?? [];
  for (const name of packageNames) expect(manifestOf(name).version, name).toBe(version);
});

test('what was renamed is exported under its new name alone', () => {
  const rows = [...text.matchAll(/^\| (`[^|]+) \| (`[^|]+) \|$/gm)];
  expect(rows.length).toBeGreaterThan(10);
  const index = readFileSync('packages/physics/src/index.ts', 'utf8');
  for (const [, from, to] of rows) {
    const names = (cell: string) => [...cell.matchAll(/`(\w+)`/g)].map(([, name]) => name);
    for (const name of names(from)) expect(Object.keys(physics)).not.toContain(name);
    // Names of systems that are not exported, and of fields, are not in the index.
    for (const name of names(to)) {
      if (!['integrateRotation', 'droppedCount'].includes(name)) expect(index).toMatch(new RegExp(`\\b${name}\\b`));
    }
  }
});

test('pages use no name that was renamed', () => {
  const gone =
    /\b(checkFinite|polygonUpthrust|bendGrip|limited\(|tellContacts|openContacts|largestStretch|rmsStretch)\b/;
  for (const name of readdirSync('docs').filter((file) => file.endsWith('.md'))) {
    expect(readFileSync(`docs/${name}`, 'utf8'), name).not.toMatch(gone);
  }
});
