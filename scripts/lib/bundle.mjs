/** One set of esbuild options for the games site, the bench, the size report and the pages of browser tests. */
import { root } from './paths.mjs';

/**
 * Bundles from the workspace sources (the `principia-source` condition), so nothing has to be built first.
 * @param {import('esbuild').BuildOptions} options what differs from the shared set
 * @returns {import('esbuild').BuildOptions}
 */
export function bundleOptions(options) {
  return {
    absWorkingDir: root,
    bundle: true,
    format: 'esm',
    target: 'es2022',
    conditions: ['principia-source'],
    sourcemap: 'linked',
    logLevel: 'silent',
    ...options,
  };
}
