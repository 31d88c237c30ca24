// The import map of docs/in-your-own-project.md names every module that a page cannot find by itself, and the table of
// conditions is that of the package.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { drawingMapOf, importMapOf } from '../support/import-map.ts';

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

/** The names that the modules of a package import, other than files of its own and what only types are of. */
function namesImportedBy(name: string): string[] {
  const folder = `packages/${name}/src`;
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((file) =>
    /(?<!\.test)\.ts$/.test(file),
  );
  const names = files.flatMap((file) => {
    const statements = readFileSync(`${folder}/${file}`, 'utf8').matchAll(
      /^(?:import|export)\s(?!type\b)(?:[^;'"]*?\sfrom\s)?\s*'([^'.][^']*)'/gm,
    );
    return [...statements].map(([, from]) => from as string);
  });
  return [...new Set(names)];
}

test.each(['render-pixi', 'render-three'])('the maps have every name that the modules of %s import', (renderer) => {
  const all = { ...map, ...drawingMapOf(page, renderer) };
  const imported = ['physics', 'render-core', renderer].flatMap(namesImportedBy);
  expect(imported).toContain(
    renderer === 'render-pixi' ? 'pixi.js/mesh' : 'three/examples/jsm/controls/OrbitControls.js',
  );
  const isMapped = (name: string) =>
    name in all || Object.keys(all).some((key) => key.endsWith('/') && name.startsWith(key));
  expect(imported.filter((name) => !isMapped(name))).toEqual([]);
  for (const address of Object.values(drawingMapOf(page, renderer))) {
    const [, library, version] = /\/npm\/(@?[^@]+)@([^/]+)\//.exec(address) ?? [];
    const folder = library?.startsWith('@principia/')
      ? library.replace('@principia', 'packages')
      : `node_modules/${library}`;
    expect(version).toBe(JSON.parse(readFileSync(`${folder}/package.json`, 'utf8')).version);
  }
});

test('the conditions and peers that the page names exist', () => {
  expect(Object.keys(manifest.imports['#f64/*'])).toContain('principia-f32');
  expect(Object.keys(manifest.imports['#f32/*'])).toContain('principia-f64');
  const pixi = JSON.parse(readFileSync('node_modules/pixi.js/package.json', 'utf8'));
  expect(Object.keys(pixi.exports)).toContain('./unsafe-eval');
});
