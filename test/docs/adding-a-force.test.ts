// The law and the test of docs/adding-a-force.md, as they stand there: checked by the strict compiler and run. What the
// page adds to lists is looked for in the lists.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { importBundled, type PageFiles, typeErrorsOf, writeFilesOf } from '../support/page-files.ts';

/** In place of vitest: the tests of the page run where they are read. */
const VITEST = `
export const expect = globalThis.expectOfPage;
export const ran = [];
export function test(name, run) {
  run();
  ran.push(name);
}
`;

describe('docs/adding-a-force.md', () => {
  let written: PageFiles;
  beforeAll(() => {
    written = writeFilesOf('adding-a-force');
  });

  it('has a law and a test', () => {
    expect(written.files.map(({ path }) => path)).toEqual([
      'packages/physics/src/forces/bowl.ts',
      'packages/physics/src/forces/bowl.test.ts',
    ]);
  });

  it('names files, lists and tests that there are', () => {
    for (const [, path] of written.page.matchAll(/`((?:packages|test|scripts)\/[\w./-]+)`/g)) {
      expect(existsSync(path), path).toBe(true);
    }
    expect(readFileSync('test/support/law-records.ts', 'utf8')).toMatch(/^ {2}law\('uniformGravity'/m);
    expect(readFileSync('packages/physics/src/index.ts', 'utf8')).toContain("from './forces/vortex.ts';");
  });

  it('type-checks', () => expect(typeErrorsOf(written)).toBe(''), 60_000);

  it('runs, and its test passes', async () => {
    Object.assign(globalThis, { expectOfPage: expect });
    const vitest = `${written.copy}/vitest.ts`;
    writeFileSync(vitest, VITEST);
    const code = "import 'COPY/packages/physics/src/forces/bowl.test';\nexport { ran } from 'vitest';\n";
    const { ran } = await importBundled(written, code, { vitest });
    expect(ran).toHaveLength(1);
  });
});
