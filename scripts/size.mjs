/** What the physics package costs a game: minified and gzipped, both precisions in it, bitECS left out. */
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { buildKernels } from './build-kernels.mjs';
import { bundleOptions } from './lib/bundle.mjs';
import { reportFailure } from './lib/report-failure.mjs';

const limit = 40 * 1024;

try {
  await buildKernels();
  const whole = await measure({ entryPoints: ['packages/physics/src/index.ts'] });
  const kernels = await measure({ entryPoints: ['packages/physics/src/kernels/modules.gen.ts'] });
  const rest = { minified: whole.minified - kernels.minified, gzip: whole.gzip - kernels.gzip };
  const rows = [
    row('physics', whole),
    row('  kernels', kernels),
    row('  TypeScript', { ...rest, brotli: whole.brotli - kernels.brotli }),
  ];
  process.stdout.write(`${['', 'minified', 'gzip', 'brotli'].map(cell).join('')}\n${rows.join('\n')}\n`);
  if (whole.gzip > limit) {
    throw new Error(`The physics package weighs ${kilobytes(whole.gzip)} gzipped; its limit is ${kilobytes(limit)}.`);
  }
  process.stdout.write(`Limit ${kilobytes(limit)} gzipped, ${kilobytes(limit - whole.gzip)} left\n`);
} catch (error) {
  await reportFailure(error);
}

/** @param {import('esbuild').BuildOptions} options */
async function measure(options) {
  const { outputFiles } = await build({
    ...bundleOptions({ minify: true, sourcemap: false, external: ['bitecs'], ...options }),
    write: false,
  });
  const code = outputFiles[0].contents;
  return {
    minified: code.length,
    gzip: gzipSync(code, { level: 9 }).length,
    brotli: brotliCompressSync(code).length,
  };
}

/**
 * @param {string} name
 * @param {{ minified: number, gzip: number, brotli: number }} sizes
 */
function row(name, { minified, gzip, brotli }) {
  return [name, ...[minified, gzip, brotli].map(kilobytes)].map(cell).join('');
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
  return column === 0 ? text.padEnd(14) : text.padStart(11);
}
