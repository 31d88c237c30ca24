/** How esbuild turns `games/<name>/main.ts` into scripts that share their common chunks. */
import { readdirSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { buildKernels, kernelFolder } from '../build-kernels.mjs';
import { bundleOptions } from './bundle.mjs';
import { pixiPlugins } from './pixi-parts.mjs';
import { gameNames } from './site-pages.mjs';

/**
 * Every address in the output is relative, so the site works from any folder of any server.
 * @param {import('esbuild').BuildOptions} options
 */
export function siteOptions(options) {
  return bundleOptions({
    entryPoints: gameNames().map((name) => `games/${name}/main.ts`),
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
 * Compiles the kernels when the bundle asks for them, and lets esbuild watch their sources.
 * @type {import('esbuild').Plugin}
 */
export const kernelsPlugin = {
  name: 'kernels',
  setup(build) {
    // Generated files may not be there yet, so esbuild cannot resolve them itself.
    build.onResolve({ filter: /^\..*\/[\w-]+\.gen\.ts$/ }, ({ path, resolveDir }) => ({
      path: resolve(resolveDir, path),
    }));
    build.onLoad({ filter: /\.gen\.ts$/ }, async ({ path }) => {
      const entries = readdirSync(kernelFolder, { recursive: true, withFileTypes: true });
      const watched = {
        watchDirs: [kernelFolder, ...entries.filter((e) => e.isDirectory()).map((e) => `${e.parentPath}/${e.name}`)],
        watchFiles: entries.filter((e) => e.name.endsWith('.ts')).map((e) => `${e.parentPath}/${e.name}`),
      };
      try {
        await buildKernels();
        return { ...watched, contents: readFileSync(path, 'utf8'), loader: 'ts' };
      } catch (error) {
        return { ...watched, errors: [{ text: error instanceof Error ? error.message : String(error) }] };
      }
    });
  },
};
