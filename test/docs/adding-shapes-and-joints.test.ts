// The code of docs/adding-a-shape.md, checked by the strict compiler and run, and the files that it and docs/adding-a-joint.md
// name; and what the latter promises: that a new kind of joint needs no more than the places it names.
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { importBundled, typeErrorsOf, writeFilesOf } from '../support/page-files.ts';

const VITEST = `
export const expect = globalThis.expectOfPage;
export const ran = [];
export function test(name, run) {
  run();
  ran.push(name);
}
`;

it.each(['adding-a-shape', 'adding-a-joint'])('docs/%s.md names files that there are', (name) => {
  const page = readFileSync(`docs/${name}.md`, 'utf8');
  expect(page).not.toMatch(/`(src|kernels)\//);
  for (const [, path] of page.matchAll(/`((?:packages|test|scripts)\/[\w./-]+)`/g)) {
    if (!/\/(triangle|groove)\.ts$/.test(path)) expect(existsSync(path), path).toBe(true);
  }
});

describe('docs/adding-a-shape.md', () => {
  const written = writeFilesOf('adding-a-shape');

  it('type-checks', () => expect(typeErrorsOf(written)).toBe(''), 60_000);

  it('runs, and its test passes', async () => {
    Object.assign(globalThis, { expectOfPage: expect });
    const vitest = `${written.copy}/vitest.ts`;
    writeFileSync(vitest, VITEST);
    const test =
      "import 'COPY/packages/physics/src/collision/shapes/2d/triangle.test';\nexport { ran } from 'vitest';\n";
    expect((await importBundled(written, test, { vitest })).ran).toHaveLength(1);
  });
});

describe('docs/adding-a-joint.md', () => {
  it('may append a kind: no kernel asks which kinds stand before or after another', () => {
    const folder = 'packages/physics/kernels/joints/2d';
    for (const name of readdirSync(folder)) {
      expect(readFileSync(`${folder}/${name}`, 'utf8'), name).not.toMatch(/\bkind\s*(<|>)=?\s/);
    }
  });

  it('gives each option that may be left out its default, and the function a comment', () => {
    const page = readFileSync('docs/adding-a-joint.md', 'utf8');
    const optional = [...page.matchAll(/(\/\*\*.*\*\/)\n\s*readonly \w+\?:/g)];
    expect(optional.length).toBeGreaterThan(0);
    for (const [, comment] of optional) expect(comment).toMatch(/[Dd]efault/);
    expect(page).toMatch(/\* A .*\n\s*\* @throws.*\n\s*\*\/\n\s*export function groove\(/);
  });

  it('names every file that lists the kinds of joints', () => {
    const page = readFileSync('docs/adding-a-joint.md', 'utf8');
    const folder = 'packages/physics';
    const files = readdirSync(folder, { recursive: true, encoding: 'utf8' })
      .filter((path) => /^(src|kernels)\/.*\.ts$/.test(path) && !path.endsWith('.test.ts'))
      .filter((path) => !/^src\/(joints\/wheel|kernels\/.*\.gen)\.ts$/.test(path));
    const lists = files.filter((path) =>
      /\bWHEEL\b|'wheel'|^ {2}wheel:/m.test(readFileSync(`${folder}/${path}`, 'utf8')),
    );
    expect(lists.filter((path) => !page.includes(`${folder}/${path}`))).toEqual([]);
    expect(lists.length).toBeGreaterThan(4);
  });
});
