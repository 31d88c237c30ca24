/** Makes the picture of docs/n-body.md: what direct sum and tree cost by the number of bodies, in a minute. */
import { mkdirSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { buildKernels } from './build-kernels.mjs';
import { bundleOptions } from './lib/bundle.mjs';
import { cacheFolder, root } from './lib/paths.mjs';
import { reportFailure } from './lib/report-failure.mjs';

const outfile = `${cacheFolder}/n-body-costs.mjs`;

try {
  await buildKernels();
  await build(bundleOptions({ entryPoints: ['bench/n-body-costs.ts'], outfile, platform: 'node' }));
  const { costChart } = await import(pathToFileURL(outfile).href);
  mkdirSync(`${root}/docs/images`, { recursive: true });
  writeFileSync(`${root}/docs/images/n-body.svg`, `${costChart()}\n`);
} catch (error) {
  await reportFailure(error);
}
