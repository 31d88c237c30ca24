import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { peersChart } from '../../scripts/lib/peers-chart.mjs';
import { readPeers, SCENES } from '../../scripts/lib/peers-table.mjs';

const rows = readPeers(readFileSync('docs/rigid-bodies.md', 'utf8'));

test('the picture of other engines shows the table beside it (node scripts/peers-page.mjs)', () => {
  expect(readFileSync('docs/images/rigid-peers.svg', 'utf8')).toBe(peersChart(rows));
  expect(rows.map(({ title }) => title)).toEqual([...SCENES.map(({ title }) => title), 'geometric mean']);
});

test('the last row is the mean of the others', () => {
  const means = rows.at(-1)?.ratios as number[];
  means.forEach((mean, i) => {
    const logs = rows.slice(0, -1).map(({ ratios }) => Math.log(ratios[i]));
    const exact = Math.exp(logs.reduce((sum, log) => sum + log, 0) / logs.length);
    // Both are rounded to a decimal, or to whole numbers from ten on.
    expect(Math.abs(mean - exact)).toBeLessThan(mean < 10 ? 0.11 : 1.1);
  });
});
