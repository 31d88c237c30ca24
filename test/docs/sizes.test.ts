import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { bundles } from '../../scripts/lib/size-limits.mjs';
import { withMarkedPart } from './marked-table.ts';

test('docs/bench.md has the sizes that `npm run size` holds; `npx vitest run test/docs/sizes.test.ts -u` writes it', async () => {
  const rows = bundles.flatMap(({ title, limits }) =>
    title === undefined ? [] : [`| ${title} | ${limits.map((limit) => `${Math.round(limit)} KB`).join(' | ')} |`],
  );
  const part = ['| | both | f32 |', '|---|--:|--:|', ...rows].join('\n');
  await expect(withMarkedPart(readFileSync('docs/bench.md', 'utf8'), part)).toMatchFileSnapshot('../../docs/bench.md');
});
