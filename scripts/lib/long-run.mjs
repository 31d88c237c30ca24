/** Runs `test/memory/long-run.ts`, and fits a line to the size of the heap. */
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';
import { build } from 'esbuild';
import { bundleOptions } from './bundle.mjs';
import { cacheFolder } from './paths.mjs';

/** Steps between two measurements, as in the program. */
export const ROUND = 10_000;

/** Share of the measurements that are left out at the start: caches and compilers fill. */
const WARM_UP = 0.2;

/**
 * The optimising compilers put code on the heap for as long as rarely called functions warm up, hundreds of thousands of
 * steps: without them what grows is data. Code and feedback are made at the first call, and stay.
 */
const FLAGS = ['--no-opt', '--no-maglev', '--always-sparkplug', '--no-lazy-feedback-allocation', '--no-flush-bytecode'];

/**
 * @param {number} steps
 * @param {() => void} onRound
 * @returns {Promise<number>} slope of the heap, bytes per round
 */
export async function heapSlope(steps, onRound) {
  const outfile = `${cacheFolder}/long-run.mjs`;
  await build(bundleOptions({ entryPoints: ['test/memory/long-run.ts'], outfile, platform: 'node', target: 'node20' }));
  const child = spawn(process.execPath, [...FLAGS, '--expose-gc', outfile, `${steps}`], {
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  /** @type {number[]} */
  const sizes = [];
  for await (const line of createInterface({ input: child.stdout })) {
    sizes.push(Number(line));
    onRound();
  }
  const code = child.exitCode ?? (await new Promise((resolve) => child.on('exit', resolve)));
  if (code !== 0) throw new Error('The long run failed.');
  return slopeOf(sizes.slice(Math.floor(WARM_UP * sizes.length)));
}

/** @param {readonly number[]} values equally spaced */
function slopeOf(values) {
  const middle = (values.length - 1) / 2;
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const products = values.reduce((sum, value, i) => sum + (i - middle) * (value - mean), 0);
  const squares = values.reduce((sum, _, i) => sum + (i - middle) ** 2, 0);
  return products / squares;
}
