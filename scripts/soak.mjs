/**
 * Random operations on worlds until a given number of them has been done, with the invariants of the engine checked after
 * each; then a long run of worlds that use most features at once, whose heap must not grow by more than a kilobyte in ten
 * thousand steps. `npm run soak -- [--operations 1000000] [--seed 1] [--steps 1000000]`; a failure prints its seed and the
 * shortest list of operations that shows it.
 */
import { spawnSync } from 'node:child_process';
import { SingleBar } from 'cli-progress';
import { commandOptions, numberOption, refuse } from './lib/command-options.mjs';
import { heapSlope, ROUND } from './lib/long-run.mjs';
import { resolveInstalled, root } from './lib/paths.mjs';

const values = commandOptions({
  operations: { type: 'string', default: '1000000' },
  seed: { type: 'string', default: '1' },
  steps: { type: 'string', default: '1000000' },
});

/** Runs of a batch, and operations of a run in the mean of both tests: one has a third of the runs of the other. */
const RUNS = 900;
const OPERATIONS_PER_RUN = 30 * (4 / 3);

const operations = numberOption('operations', values.operations, { min: 0 });
const firstSeed = numberOption('seed', values.seed, { min: 0 });
const steps = numberOption('steps', values.steps, { min: 0 });
const rounds = Math.floor(steps / ROUND);
if (steps > 0 && rounds < 2)
  refuse(`--steps must be 0 or at least ${2 * ROUND}, the rounds of the long run, not "${steps}".`);

const batches = Math.ceil(operations / (RUNS * OPERATIONS_PER_RUN));
/** @param {string} what */
const barOf = (what) =>
  new SingleBar({ format: `{bar} {percentage}% | {value} of {total} ${what} | {eta} s left`, clearOnComplete: true });

const bar = barOf('batches of operations');
bar.start(batches, 0);
for (let batch = 0; batch < batches; batch++) {
  const seed = firstSeed + 2 * batch;
  const env = { ...process.env, SOAK_RUNS: `${RUNS}`, SOAK_SEED: `${seed}` };
  const args = [
    resolveInstalled('vitest/package.json').replace(/package\.json$/, 'vitest.mjs'),
    'run',
    '--project',
    'unit',
    '--testTimeout',
    '600000',
  ];
  const { status, stdout } = spawnSync(process.execPath, [...args, 'test/faults/operations.test.ts'], {
    cwd: root,
    env,
  });
  if (status !== 0) {
    bar.stop();
    process.stderr.write(`${stdout}\nFailed with --seed ${seed}.\n`);
    process.exit(1);
  }
  bar.increment();
}
bar.stop();
process.stdout.write(`${batches * RUNS * OPERATIONS_PER_RUN} random operations, no invariant broken.\n`);

/** Largest growth of the heap in a round of the long run, bytes. */
const MAX_SLOPE = 1024;

if (rounds > 0) {
  const runBar = barOf(`rounds of ${ROUND} steps`);
  runBar.start(rounds, 0);
  const slope = await heapSlope(rounds * ROUND, () => runBar.increment()).finally(() => runBar.stop());
  process.stdout.write(`${rounds * ROUND} steps; the heap grew by ${slope.toFixed(0)} bytes in ${ROUND} of them.\n`);
  if (!(slope <= MAX_SLOPE)) process.exit(1);
}
