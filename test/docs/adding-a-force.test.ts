// The law and the test of docs/adding-a-force.md, as they stand there: checked by the strict compiler and run. What the
// page adds to lists is looked for in the lists.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { build, type Plugin } from 'esbuild';
import { beforeAll, describe, expect, it } from 'vitest';

const page = readFileSync('docs/adding-a-force.md', 'utf8');
const copy = resolve('node_modules/.cache/principia/adding-a-force');
const forces = `${copy}/packages/physics/src/forces`;

/** The blocks of the page that begin with the path of a file. */
const files = [...page.matchAll(/^ *```\w+\n( *)\/\/ (packages\/\S+)\n([\s\S]*?)^ *```$/gm)].map(
  ([, indent, path, code]) => ({ path, code: code.replaceAll(new RegExp(`^${indent}`, 'gm'), '') }),
);

/** In place of vitest: the tests of the page run where they are read. */
const VITEST = `
export const expect = globalThis.expectOfPage;
export const ran = [];
export function test(name, run) {
  run();
  ran.push(name);
}
`;

beforeAll(() => {
  rmSync(copy, { recursive: true, force: true });
  mkdirSync(forces, { recursive: true });
  for (const { path, code } of files) writeFileSync(`${copy}/${path}`, code);
});

/** Files of the page stand in the package as far as their imports go. */
const inPackage: Plugin = {
  name: 'in-package',
  setup({ onResolve }) {
    onResolve({ filter: /^\./ }, ({ path, importer }) => {
      if (!importer.startsWith(copy) || existsSync(resolve(dirname(importer), path))) return undefined;
      const place = dirname(importer).slice(copy.length + 1);
      return { path: resolve(place, path) };
    });
    onResolve({ filter: /^vitest$/ }, () => ({ path: `${copy}/vitest.ts` }));
  },
};

describe('docs/adding-a-force.md', () => {
  it('has a law and a test', () => {
    expect(files.map(({ path }) => path)).toEqual([
      'packages/physics/src/forces/bowl.ts',
      'packages/physics/src/forces/bowl.test.ts',
    ]);
  });

  it('names files, lists and tests that there are', () => {
    for (const [, path] of page.matchAll(/`((?:packages|test|scripts)\/[\w./-]+)`/g)) {
      expect(existsSync(path), path).toBe(true);
    }
    expect(readFileSync('test/support/law-records.ts', 'utf8')).toMatch(/^ {2}law\('uniformGravity'/m);
    expect(readFileSync('packages/physics/src/index.ts', 'utf8')).toContain("from './forces/vortex.ts';");
  });

  it('type-checks', () => {
    const tsconfig = {
      extends: resolve('tsconfig.json'),
      compilerOptions: {
        rootDirs: [copy, resolve('.')],
        typeRoots: [resolve('node_modules/@types')],
      },
      include: [`${forces}/*.ts`],
    };
    writeFileSync(`${copy}/tsconfig.json`, JSON.stringify(tsconfig));
    try {
      execFileSync(process.execPath, ['node_modules/typescript/bin/tsc', '-p', copy], { encoding: 'utf8' });
    } catch (error) {
      expect.fail((error as { stdout: string }).stdout);
    }
  }, 60_000);

  it('runs, and its test passes', async () => {
    Object.assign(globalThis, { expectOfPage: expect });
    writeFileSync(`${copy}/vitest.ts`, VITEST);
    writeFileSync(`${copy}/all.ts`, `import '${forces}/bowl.test';\nexport { ran } from 'vitest';\n`);
    const outfile = `${copy}/all.mjs`;
    await build({
      entryPoints: [`${copy}/all.ts`],
      outfile,
      bundle: true,
      format: 'esm',
      platform: 'node',
      conditions: ['principia-source'],
      plugins: [inPackage],
      logLevel: 'silent',
    });
    const { ran } = (await import(outfile)) as { ran: string[] };
    expect(ran).toHaveLength(1);
  });
});
