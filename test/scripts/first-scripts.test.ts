import { expect, test } from 'vitest';
import { firstScripts, startSooner } from '../../scripts/lib/first-scripts.mjs';

type Outputs = Parameters<typeof firstScripts>[0];

const output = (imports: [path: string, kind: 'import-statement' | 'dynamic-import'][] = [], entryPoint?: string) => ({
  bytes: 1,
  inputs: {},
  exports: [],
  imports: imports.map(([path, kind]) => ({ path: `dist/${path}`, kind })),
  ...(entryPoint === undefined ? {} : { entryPoint }),
});

const outputs = {
  'dist/laboratory/main.js': output([
    ['chunks/list.js', 'import-statement'],
    ['chunks/start.js', 'dynamic-import'],
    ['chunks/example.js', 'dynamic-import'],
  ]),
  'dist/chunks/list.js': output(),
  'dist/chunks/start.js': output([['chunks/shell.js', 'import-statement']]),
  'dist/chunks/example.js': output(
    [
      ['chunks/list.js', 'import-statement'],
      ['chunks/shell.js', 'import-statement'],
    ],
    'games/laboratory/example-page.ts',
  ),
  'dist/chunks/shell.js': output(),
} as Outputs;

test('a page that opens another part by its address fetches the scripts of that part', () => {
  const scripts = firstScripts(outputs, 'dist/laboratory/main.js');
  expect(scripts).toEqual({
    shared: ['../chunks/list.js'],
    picture: ['../chunks/start.js', '../chunks/shell.js'],
    other: { parameter: 'example', scripts: ['../chunks/example.js', '../chunks/shell.js'] },
  });
  const html = startSooner('<head></head>', scripts);
  expect(html).toContain('<link rel="modulepreload" href="../chunks/list.js">');
  expect(html).toContain(`has('example') ? ["../chunks/example.js","../chunks/shell.js"] : ["../chunks/start.js"`);
});

test('other pages fetch the scripts of their first picture', () => {
  const plain = Object.fromEntries(
    Object.entries(outputs).map(([path, each]) => [path.replace('laboratory', 'cloth'), each]),
  ) as Outputs;
  const scripts = firstScripts(plain, 'dist/cloth/main.js');
  expect(scripts.other).toBeUndefined();
  expect(startSooner('<head></head>', scripts)).not.toContain('URLSearchParams');
});
