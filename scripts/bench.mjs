/** Bundles `bench/main.ts` and runs it in a Node of its own: `npm run bench -- <arguments of the bench>`. */
import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { buildKernels } from './build-kernels.mjs';
import { bundleOptions } from './lib/bundle.mjs';
import { cacheFolder, root } from './lib/paths.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { runNode } from './lib/run.mjs';

const outfile = `${cacheFolder}/bench.mjs`;

try {
  if (!existsSync(`${root}/bench/main.ts`)) throw new Error('bench/main.ts is missing: there is nothing to measure.');
  await buildKernels();
  await build(
    bundleOptions({
      entryPoints: ['bench/main.ts'],
      outfile,
      platform: 'node',
      target: 'node20',
      plugins: [onlyOurs()],
    }),
  );
  process.exitCode = await runNode(['--expose-gc', '--enable-source-maps', outfile, ...process.argv.slice(2)]);
} catch (error) {
  await reportFailure(error);
}

/**
 * Leaves installed packages to Node, so that peers run as they are published, and scripts (`*.mjs`) where they stand,
 * so that they find their neighbours; TypeScript and workspace packages are bundled.
 * @returns {import('esbuild').Plugin}
 */
function onlyOurs() {
  return {
    name: 'only-ours',
    setup({ onResolve }) {
      onResolve({ filter: /^[^./#]/ }, ({ path, kind }) =>
        kind === 'entry-point' || path.startsWith('@principia/') ? undefined : { path, external: true },
      );
      onResolve({ filter: /^\..*\.mjs$/ }, ({ path, resolveDir }) => ({
        path: pathToFileURL(resolve(resolveDir, path)).href,
        external: true,
      }));
    },
  };
}
