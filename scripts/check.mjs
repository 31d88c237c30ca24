/** Everything that must hold before a change is merged; the tests come last, and so does their count. */
import { buildExamples } from './build-examples.mjs';
import { buildKernels } from './build-kernels.mjs';
import { resolveInstalled } from './lib/paths.mjs';
import { runNode } from './lib/run.mjs';
import { printCount, runTests } from './test.mjs';

const biome = resolveInstalled('@biomejs/biome/bin/biome');
const typescript = resolveInstalled('typescript/package.json').replace(/package\.json$/, 'bin/tsc');

/** @type {readonly (readonly [name: string, step: () => Promise<boolean>])[]} */
const steps = [
  ['kernels', generate],
  ['lint', () => succeeds(biome, 'check', '--error-on-warnings', '.')],
  ['kernel format', () => succeeds('scripts/format-kernels.mjs')],
  ['types', () => succeeds(typescript, '-p', 'tsconfig.json')],
  ['packages', () => succeeds('scripts/check-packages.mjs')],
  ['size', () => succeeds('scripts/size.mjs')],
  ['site', () => succeeds('scripts/site.mjs')],
];

const outcomes = [];
for (const [name, step] of steps) outcomes.push(await timed(name, step));
const start = performance.now();
const count = await runTests();
outcomes.push(line('tests', count.ok, start));

process.stdout.write(`\n${outcomes.join('\n')}\n`);
if (outcomes.some((outcome) => outcome.startsWith('FAILED'))) process.exitCode = 1;
printCount(count);

/** Compiles the kernels, and lists the examples, which the types of the laboratory need. */
async function generate() {
  await buildKernels();
  await buildExamples();
  return true;
}

/** @param {readonly string[]} args */
async function succeeds(...args) {
  return (await runNode(args)) === 0;
}

/**
 * @param {string} name
 * @param {() => Promise<boolean>} step
 */
async function timed(name, step) {
  process.stdout.write(`\n— ${name}\n`);
  const start = performance.now();
  try {
    return line(name, await step(), start);
  } catch (error) {
    process.stderr.write(`${error instanceof Error ? error.message : error}\n`);
    return line(name, false, start);
  }
}

/**
 * @param {string} name
 * @param {boolean} ok
 * @param {number} start
 */
function line(name, ok, start) {
  return `${ok ? 'ok    ' : 'FAILED'} ${name.padEnd(14)} ${((performance.now() - start) / 1000).toFixed(1)} s`;
}
