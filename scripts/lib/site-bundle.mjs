/** How esbuild turns `games/<name>/main.ts` into scripts that share their common chunks. */
import { readdirSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { buildExamples, examplesFolder } from '../build-examples.mjs';
import { buildKernels, kernelFolder } from '../build-kernels.mjs';
import { bundleOptions } from './bundle.mjs';
import { pixiPlugins } from './pixi-parts.mjs';
import { gameNames } from './site-pages.mjs';

/**
 * Games that share no scripts with the others: the examples of the laboratory use all of the physics, which every game would
 * load if they shared it.
 */
const ALONE = ['laboratory'];

/**
 * The bundles of the site, each with some of the games. Every address in the output is relative, so the site works from any
 * folder of any server.
 * @param {import('esbuild').BuildOptions} options
 * @returns {import('esbuild').BuildOptions[]}
 */
export function siteBundles(options) {
  const names = gameNames();
  const groups = [
    names.filter((name) => !ALONE.includes(name)),
    ...ALONE.filter((name) => names.includes(name)).map((name) => [name]),
  ];
  return groups.filter((group) => group.length > 0).map((group) => siteOptions(group, options));
}

/**
 * @param {readonly string[]} names of the games
 * @param {import('esbuild').BuildOptions} options
 */
function siteOptions(names, options) {
  return bundleOptions({
    entryPoints: names.map((name) => `games/${name}/main.ts`),
    outbase: 'games',
    outdir: 'dist/site',
    entryNames: '[dir]/[name]',
    chunkNames: 'chunks/[name]-[hash]',
    assetNames: 'assets/[name]-[hash]',
    splitting: true,
    loader: { '.png': 'file', '.jpg': 'file', '.svg': 'file', '.ogg': 'file', '.mp3': 'file', '.woff2': 'file' },
    plugins: [kernelsPlugin, ...pixiPlugins],
    metafile: true,
    ...options,
  });
}

/**
 * What moves on the front page, a bundle of its own with the one precision that it uses: visitors who play nothing
 * load little.
 * @param {import('esbuild').BuildOptions} options
 */
export function frontPageOptions(options) {
  return bundleOptions({
    entryPoints: { 'front-page': 'games/front-page/page.ts' },
    outdir: 'dist/site',
    plugins: [kernelsPlugin],
    minify: true,
    conditions: ['principia-source', 'production', 'principia-f32'],
    ...options,
  });
}

/**
 * Compiles the kernels and lists the examples when the bundle asks for them, and lets esbuild watch their sources.
 * @type {import('esbuild').Plugin}
 */
export const kernelsPlugin = {
  name: 'kernels',
  setup(build) {
    /** @type {Promise<unknown> | undefined} */
    let generated;
    build.onStart(() => {
      generated = undefined;
    });
    // Generated files may not be there yet, so esbuild cannot resolve them itself.
    build.onResolve({ filter: /^\..*\/[\w-]+\.gen\.ts$/ }, ({ path, resolveDir }) => ({
      path: resolve(resolveDir, path),
    }));
    build.onLoad({ filter: /\.gen\.ts$/ }, async ({ path }) => {
      const isList = /(scenes|laboratory)\/.*\.gen\.ts$/.test(path);
      const watched = sourcesBelow(isList ? examplesFolder : kernelFolder);
      try {
        generated ??= buildKernels().then(buildExamples);
        await generated;
        return { ...watched, contents: readFileSync(path, 'utf8'), loader: 'ts' };
      } catch (error) {
        return { ...watched, errors: [{ text: error instanceof Error ? error.message : String(error) }] };
      }
    });
  },
};

/**
 * What esbuild watches for a generated file.
 * @param {string} folder
 */
function sourcesBelow(folder) {
  const entries = readdirSync(folder, { recursive: true, withFileTypes: true });
  const isSource = (/** @type {string} */ name) => name.endsWith('.ts') && !name.endsWith('.gen.ts');
  return {
    watchDirs: [folder, ...entries.filter((e) => e.isDirectory()).map((e) => `${e.parentPath}/${e.name}`)],
    watchFiles: entries.filter((e) => isSource(e.name)).map((e) => `${e.parentPath}/${e.name}`),
  };
}
