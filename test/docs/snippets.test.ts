// The code in the documentation is compiled by the strict compiler and run, so that it cannot grow old unnoticed; code
// that needs a page to draw on is compiled alone. So is the code that the packages show on their front pages.
// All `ts` blocks of a page together are one module.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { build } from 'esbuild';
import { beforeAll, describe, expect, it } from 'vitest';
import { codeOf, packageNames, readmeOf } from '../../scripts/lib/packages.mjs';

const folder = resolve('node_modules/.cache/principia/docs');
const documents = readdirSync('docs').filter((name) => name.endsWith('.md'));
const pages = [
  ...documents.map((name) => ({ name: name.replace('.md', ''), code: codeOf(readFileSync(`docs/${name}`, 'utf8')) })),
  ...packageNames.map((name) => ({ name: `package-${name}`, code: codeOf(readmeOf(name)) })),
].filter(({ code }) => code.includes('import '));

beforeAll(() => {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const { name, code } of pages) writeFileSync(`${folder}/${name}.ts`, `${code}\nexport {};\n`);
  const tsconfig = {
    extends: resolve('tsconfig.json'),
    compilerOptions: { noUnusedLocals: false, typeRoots: [resolve('node_modules/@types')] },
    include: ['*.ts'],
  };
  writeFileSync(`${folder}/tsconfig.json`, JSON.stringify(tsconfig));
});

describe('documentation', () => {
  it('has pages with code', () => expect(pages.map(({ name }) => name)).toContain('adding-a-force'));

  it.each(packageNames)('shows how %s is used', (name) => {
    expect(pages.map((page) => page.name)).toContain(`package-${name}`);
  });

  it('type-checks', () => {
    try {
      execFileSync(process.execPath, ['node_modules/typescript/bin/tsc', '-p', folder], { encoding: 'utf8' });
    } catch (error) {
      expect.fail((error as { stdout: string }).stdout);
    }
  }, 60_000);

  const headless = pages.filter(({ code }) => !/from '(three|pixi\.js|@principia\/render-pixi)'/.test(code));

  it.each(headless.map(({ name }) => name))('%s runs', async (name) => {
    const outfile = `${folder}/${name}.mjs`;
    await build({
      entryPoints: [`${folder}/${name}.ts`],
      outfile,
      bundle: true,
      format: 'esm',
      platform: 'node',
      conditions: ['principia-source'],
      logLevel: 'silent',
    });
    await expect(import(outfile)).resolves.toBeDefined();
  });
});
