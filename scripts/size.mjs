/**
 * What the physics costs a game: minified and gzipped, bitECS left out, with both precisions in it and with one. It is
 * bundled from what npm would publish, as by a user. A game carries what it imports, and exports nothing. Then what each
 * game's own code weighs: its files and its scene, beside the packages that all games share.
 */
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { bundleOptions } from './lib/bundle.mjs';
import { withPackedPackages } from './lib/packed-packages.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { gameNames } from './lib/site-pages.mjs';
import { bundles } from './lib/size-limits.mjs';

/** Export conditions that leave a precision out, and what the rows of the table are called. */
const PRECISIONS = [
  { title: '', conditions: [] },
  { title: ', f32', conditions: ['principia-f32'] },
];

/** Limit of a game's own code, KB gzipped. What is generated from the scenes is not the game's own. */
const GAME_LIMIT = 40;
const SHARED = [
  '*.gen.ts',
  'acorn',
  'acorn-walk',
  'sucrase',
  'uplot',
  '@principia/physics',
  '@principia/render-*',
  '@principia/shell',
  '@principia/shell/*',
  '@principia/scenes/examples',
  '@principia/scenes/examples/*',
  'bitecs',
  'pixi.js',
  'three',
  'three/*',
];

try {
  process.stdout.write(`${['', 'minified', 'gzip', 'brotli', 'limit'].map(cell).join('')}\n`);
  /** @type {string[]} */
  const tooLarge = [];
  await withPackedPackages(async (project) => {
    for (const { name: imported, imports, limits } of bundles) {
      for (const [i, { title, conditions }] of PRECISIONS.entries()) {
        const [name, limit] = [`${imported}${title}`, limits[i]];
        const size = await measure(imports, conditions, project);
        process.stdout.write(`${row(name, { ...size, limit: limit * 1024 })}\n`);
        if (size.gzip > limit * 1024)
          tooLarge.push(`${name} weighs ${kilobytes(size.gzip)} gzipped, its limit is ${limit} KB`);
      }
    }
  });
  for (const name of gameNames()) {
    const size = await measureGame(name);
    process.stdout.write(`${row(name, { ...size, limit: GAME_LIMIT * 1024 })}\n`);
    if (size.gzip > GAME_LIMIT * 1024) {
      tooLarge.push(`the game ${name} weighs ${kilobytes(size.gzip)} gzipped, its limit is ${GAME_LIMIT} KB`);
    }
  }
  if (tooLarge.length > 0) throw new Error(`Something grew: ${tooLarge.join('; ')}.`);
} catch (error) {
  await reportFailure(error);
}

/**
 * @param {string} imports names from the package's index, or `*`
 * @param {readonly string[]} conditions export conditions
 * @param {string} project a folder in which the packages are installed
 */
async function measure(imports, conditions, project) {
  const physics = "'@principia/physics'";
  const names = imports.split(/\s+/).join(', ');
  const contents =
    imports === '*' ? `export * from ${physics};` : `import { ${names} } from ${physics}; use(${names});`;
  const { outputFiles } = await build({
    ...bundleOptions({
      minify: true,
      sourcemap: false,
      external: ['bitecs'],
      conditions: ['production', ...conditions],
    }),
    stdin: { contents, resolveDir: project },
    write: false,
  });
  // Where bitECS is bundled as well, nothing imports it: its names stand nowhere.
  return sizeOf(outputFiles.map(({ text }) => Buffer.from(text.replace(/import\{[^}]*\}from"bitecs";/g, ''))));
}

/** @param {string} name of a game */
async function measureGame(name) {
  const { outputFiles } = await build({
    ...bundleOptions({ minify: true, sourcemap: false, external: SHARED, splitting: true }),
    entryPoints: [`games/${name}/main.ts`],
    outdir: 'dist/size',
    write: false,
  });
  return sizeOf(outputFiles.map(({ contents }) => contents));
}

/** @param {readonly Uint8Array[]} files */
function sizeOf(files) {
  const sum = (/** @type {(code: Uint8Array) => number} */ measured) =>
    files.reduce((total, code) => total + measured(code), 0);
  return {
    minified: sum((code) => code.length),
    gzip: sum((code) => gzipSync(code, { level: 9 }).length),
    brotli: sum((code) => brotliCompressSync(code).length),
  };
}

/**
 * @param {string} name
 * @param {{ minified: number, gzip: number, brotli: number, limit: number }} sizes
 */
function row(name, { minified, gzip, brotli, limit }) {
  return [name, ...[minified, gzip, brotli, limit].map(kilobytes)].map(cell).join('');
}

/** @param {number} bytes */
function kilobytes(bytes) {
  return `${(bytes / 1024).toFixed(1)} KB`;
}

/**
 * @param {string} text
 * @param {number} column
 */
function cell(text, column) {
  return column === 0 ? text.padEnd(19) : text.padStart(11);
}
