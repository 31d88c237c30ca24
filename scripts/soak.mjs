/**
 * Random operations on worlds until a given number of them has been done, with the invariants of the engine checked after
 * each. `npm run soak -- [--operations 1000000] [--seed 1]`; a failure prints its seed and the shortest list of operations
 * that shows it.
 */
import { spawnSync } from 'node:child_process';
import { SingleBar } from 'cli-progress';
import { commandOptions } from './lib/command-options.mjs';
import { resolveInstalled, root } from './lib/paths.mjs';

const values = commandOptions({
  operations: { type: 'string', default: '1000000' },
  seed: { type: 'string', default: '1' },
});

/** Runs of a batch, and operations of a run in the mean of both tests: one has a third of the runs of the other. */
const RUNS = 900;
const OPERATIONS_PER_RUN = 30 * (4 / 3);

const batches = Math.ceil(Number(values.operations) / (RUNS * OPERATIONS_PER_RUN));
const bar = new SingleBar({
  format: '{bar} {percentage}% | {value} of {total} batches | {eta} s left',
  clearOnComplete: true,
});
bar.start(batches, 0);
for (let batch = 0; batch < batches; batch++) {
  const seed = Number(values.seed) + 2 * batch;
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
