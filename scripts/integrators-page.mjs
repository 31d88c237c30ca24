/**
 * Makes the table of docs/integrators.md from the records of `INTEGRATORS`, and with `--picture` the picture beside it:
 * energy errors over a thousand orbits, which take half a minute.
 */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { buildKernels } from './build-kernels.mjs';
import { bundleOptions } from './lib/bundle.mjs';
import { energyChart } from './lib/energy-chart.mjs';
import { energyErrors } from './lib/energy-errors.mjs';
import { withTable } from './lib/integrators-table.mjs';
import { cacheFolder, root } from './lib/paths.mjs';
import { reportFailure } from './lib/report-failure.mjs';

const page = `${root}/docs/integrators.md`;
const outfile = `${cacheFolder}/physics.mjs`;

try {
  await buildKernels();
  await build(bundleOptions({ entryPoints: ['packages/physics/src/index.ts'], outfile, platform: 'node' }));
  const physics = await import(pathToFileURL(outfile).href);
  writeFileSync(page, withTable(readFileSync(page, 'utf8'), physics.INTEGRATORS));
  if (process.argv.includes('--picture')) {
    mkdirSync(`${root}/docs/images`, { recursive: true });
    writeFileSync(`${root}/docs/images/integrators.svg`, energyChart(energyErrors(physics)));
  }
} catch (error) {
  await reportFailure(error);
}
