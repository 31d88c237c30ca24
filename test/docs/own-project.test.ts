// The import map of docs/in-your-own-project.md names every module that a page cannot find by itself, and the table of
// conditions is that of the package.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { importMapOf } from '../support/import-map.ts';

const page = readFileSync('docs/in-your-own-project.md', 'utf8');
const manifest = JSON.parse(readFileSync('packages/physics/package.json', 'utf8'));
const map = importMapOf(page);

test('the import map has every kernel of both precisions, and the warnings, at the address that the manifest gives', () => {
  const kernels = readdirSync('packages/physics/src/kernels/f32').map((file) => file.replace('.gen.ts', ''));
  const expected = kernels.flatMap((name) => [
    [`#f32/${name}`, manifest.imports['#f32/*'].default.replace('*', name)],
    [`#f64/${name}`, manifest.imports['#f64/*']['principia-f32'].default],
  ]);
  expected.push(['#warnings', manifest.imports['#warnings'].default]);
  const cdn = `https://cdn.jsdelivr.net/npm/${manifest.name}@${manifest.version}`;
  const named = Object.entries(map).filter(([name]) => name.startsWith('#'));
  expect(Object.fromEntries(named)).toEqual(
    Object.fromEntries(expected.map(([name, path]) => [name, `${cdn}/${path.slice(2)}`])),
  );
  expect(map[manifest.name]).toBe(`${cdn}/${manifest.exports['.'].default.slice(2)}`);
});

test('the import map has the dependencies of the physics, in its versions', () => {
  const version = manifest.dependencies.bitecs;
  expect(Object.keys(manifest.dependencies)).toEqual(['bitecs']);
  expect(map.bitecs).toBe(`https://cdn.jsdelivr.net/npm/bitecs@${version}/dist/core/index.min.mjs`);
  expect(existsSync('node_modules/bitecs/dist/core/index.min.mjs')).toBe(true);
});

test('the conditions and peers that the page names exist', () => {
  expect(Object.keys(manifest.imports['#f64/*'])).toContain('principia-f32');
  expect(Object.keys(manifest.imports['#f32/*'])).toContain('principia-f64');
  const pixi = JSON.parse(readFileSync('node_modules/pixi.js/package.json', 'utf8'));
  expect(Object.keys(pixi.exports)).toContain('./unsafe-eval');
});
