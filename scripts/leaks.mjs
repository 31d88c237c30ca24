/**
 * Plays the games for minutes and looks for leaks: what they hold after garbage was collected must stop growing.
 *
 * `npm run leaks -- [--minutes 10] [--game black-hole] [--together]`; `--together` plays the games at once, in one
 * browser. `CHROMIUM` names the browser.
 */
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { commandOptions, gamesOption, numberOption } from './lib/command-options.mjs';
import { countInPage, KEPT_BY_PIXI, objectsOf, playRound, takeCounts, WITHOUT_COMPILERS } from './lib/leak-watch.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { writeSite } from './lib/site-build.mjs';
import { gameNames } from './lib/site-pages.mjs';
import { serveFiles } from './lib/static-server.mjs';

const values = commandOptions({
  minutes: { type: 'string', default: '10' },
  game: { type: 'string', multiple: true },
  together: { type: 'boolean', default: false },
});
/** Milliseconds that a game is played. */
const length = 60_000 * numberOption('minutes', values.minutes, { min: 0.01, whole: false });
// The first game of the tour has no shell, and nothing to work it by.
const names = gamesOption(
  values.game,
  gameNames().filter((name) => name !== 'first-game'),
);
/** Rounds before the first count: caches and compilers fill. */
const WARM = 5;
/** Heap that may come and go: caches, feedback of the interpreter, strings. */
const SLACK = 1e6;

const folder = mkdtempSync(join(tmpdir(), 'principia-leaks-'));
try {
  await writeSite(folder);
  const server = await serveFiles({ find: (path) => readIfThere(join(folder, path)) });
  const args = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', WITHOUT_COMPILERS];
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  const browser = await chromium.launch({ executablePath, chromiumSandbox: false, args });
  /** @type {string[]} */
  const leaks = [];
  const watchOne = async (/** @type {string} */ name) => {
    leaks.push(...(await watch(browser, `${server.url}${name}/`, name)));
  };
  if (values.together) await Promise.all(names.map(watchOne));
  else for (const name of names) await watchOne(name);
  await browser.close();
  await server.close();
  if (leaks.length > 0) throw new Error(`There are leaks: ${leaks.join('; ')}.`);
  process.stdout.write('No leak.\n');
} catch (error) {
  await reportFailure(error);
} finally {
  rmSync(folder, { recursive: true, force: true });
}

/**
 * @param {import('playwright-core').Browser} browser
 * @param {string} url
 * @param {string} name
 */
async function watch(browser, url, name) {
  const page = await browser.newPage({ viewport: { width: 640, height: 420 } });
  await page.addInitScript(countInPage);
  const session = await page.context().newCDPSession(page);
  await page.goto(`${url}?manual`);
  await page.waitForFunction(() => /** @type {any} */ (globalThis).__game?.state().ready);
  for (let round = 0; round < WARM; round++) await playRound(page, round);
  const first = await takeCounts(page, session);
  process.stdout.write(line(name, 0, 0, first));
  const start = performance.now();
  let last = first;
  let round = WARM;
  for (let shown = start; performance.now() - start < length; round++) {
    await playRound(page, round);
    if (performance.now() - shown < Math.min(30_000, length / 4)) continue;
    shown = performance.now();
    last = await takeCounts(page, session);
    process.stdout.write(line(name, (shown - start) / 1000, round, last));
  }
  await page.close();
  const grown = (/** @type {'nodes' | 'listeners' | 'contexts' | 'memories'} */ what) => last[what] > first[what];
  return [
    ...(last.heap > first.heap + SLACK + KEPT_BY_PIXI * (round - WARM)
      ? [`the heap of ${name} grew by ${last.heap - first.heap} bytes`]
      : []),
    ...(objectsOf(last) > objectsOf(first) ? [`graphics objects of ${name} grew`] : []),
    ...(grown('nodes') ? [`DOM nodes of ${name} grew`] : []),
    ...(grown('listeners') ? [`listeners of ${name} grew`] : []),
    ...(grown('contexts') ? [`contexts of ${name} grew`] : []),
    ...(grown('memories') ? [`worlds of ${name} stay`] : []),
  ];
}

/**
 * @param {string} name
 * @param {number} seconds
 * @param {number} rounds
 * @param {import('./lib/leak-watch.mjs').Counts} counts
 */
function line(name, seconds, rounds, counts) {
  const { heap, nodes, listeners, contexts, memories } = counts;
  const words = [`${name} ${seconds.toFixed(0)} s`, `${rounds} rounds`, `${(heap / 1e6).toFixed(2)} MB`];
  words.push(`${objectsOf(counts)} graphics objects`, `${contexts} contexts`, `${memories} worlds`);
  return `${[...words, `${nodes} nodes`, `${listeners} listeners`].join(', ')}\n`;
}

/** @param {string} file */
function readIfThere(file) {
  try {
    return readFileSync(file);
  } catch {
    return undefined;
  }
}
