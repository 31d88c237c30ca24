/**
 * Runs every test: `npm test`, or a part of them with vitest's own arguments, such as
 * `npm test -- packages/physics -t drag` or `npm test -- --project unit`. The last line is the runner's count.
 */
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { buildKernels } from './build-kernels.mjs';
import { cacheFolder, resolveInstalled, root } from './lib/paths.mjs';
import { runNode } from './lib/run.mjs';

/**
 * What a run of tests came to; `unsteady` are tests that passed only when they were tried again.
 * @typedef {{ passed: number, failed: number, skipped: number, failures: string[], unsteady: string[], ok: boolean }} TestCount
 */

/**
 * @param {readonly string[]} args for vitest
 * @returns {Promise<TestCount>}
 */
export async function runTests(args = []) {
  const countFile = `${cacheFolder}/test-count-${process.pid}.json`;
  mkdirSync(cacheFolder, { recursive: true });
  const vitest = resolveInstalled('vitest/package.json').replace(/package\.json$/, 'vitest.mjs');
  const reporters = ['--reporter=default', `--reporter=${root}/scripts/lib/count-reporter.mjs`];
  try {
    await buildKernels();
    const code = await runNode([vitest, 'run', ...reporters, ...args], { PRINCIPIA_TEST_COUNT: countFile });
    const count = JSON.parse(readFileSync(countFile, 'utf8'));
    return { ...count, ok: code === 0 && count.failed === 0 && count.passed > 0 };
  } catch (error) {
    process.stderr.write(`The tests did not run: ${error instanceof Error ? error.message : error}\n`);
    return { passed: 0, failed: 0, skipped: 0, failures: [], unsteady: [], ok: false };
  } finally {
    rmSync(countFile, { force: true });
  }
}

/** What failed, again at the end of a long log, and the count. @param {TestCount} count */
export function printCount({ passed, failed, skipped, failures, unsteady }) {
  for (const test of unsteady) process.stdout.write(`Passed at the second try: ${test}\n`);
  for (const test of failures) process.stdout.write(`Failed: ${test}\n`);
  if (passed + failed === 0) process.stdout.write('No test ran: that counts as a failure.\n');
  if (skipped > 0) process.stdout.write(`${skipped} skipped\n`);
  process.stdout.write(`${passed} passed, ${failed} failed\n`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const count = await runTests(process.argv.slice(2));
  printCount(count);
  process.exitCode = count.ok ? 0 : 1;
}
