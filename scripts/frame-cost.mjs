/**
 * What a frame costs in JavaScript: 100 000 particles after a step, handed to each renderer and to pixi's
 * `ParticleContainer`; 50 000 sparks of the fireworks; and every game as it opens, steps included. Medians, in milliseconds.
 *
 * `npm run frame-cost -- [--bodies 100000] [--sparks 50000] [--drawn]`; the graphics card is told nothing of what it
 * would draw, unless `--drawn`. `CHROMIUM` names the browser. Times are this machine's: compare those of one run.
 */
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build } from 'esbuild';
import { chromium } from 'playwright-core';
import { buildKernels } from './build-kernels.mjs';
import { bundleOptions } from './lib/bundle.mjs';
import { commandOptions, numberOption } from './lib/command-options.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { writeSite } from './lib/site-build.mjs';
import { gameAddress, gameNames } from './lib/site-pages.mjs';
import { serveFiles } from './lib/static-server.mjs';

/** @typedef {import('playwright-core').Browser} Browser */

const values = commandOptions({
  bodies: { type: 'string', default: '100000' },
  sparks: { type: 'string', default: '50000' },
  drawn: { type: 'boolean', default: false },
});
const bodies = numberOption('bodies', values.bodies, { min: 1 });
const sparks = numberOption('sparks', values.sparks, { min: 1 });
const ROUNDS = 6;
const FRAMES = 15;
/** Frames before the first that counts: compilers come to rest, and the sky fills with sparks. */
const WARM = 15;
const GAME_WARM = 200;
/** Pages that cannot tell what their frames cost. */
const WITHOUT_SHELL = ['first-game', 'front-page'];

/** @type {Browser | undefined} */
let browser;
const folder = mkdtempSync(join(tmpdir(), 'principia-frame-cost-'));
try {
  await buildKernels({ quiet: true });
  const flags = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  browser = await chromium.launch({ executablePath, chromiumSandbox: false, args: flags });
  await measureBodies(browser, bodies);
  await writeSite(folder);
  const server = await serveFiles({ find: (path) => readIfThere(join(folder, path)) });
  await measureSparks(browser, server.url, sparks);
  await measureGames(browser, server.url);
  await server.close();
} catch (error) {
  await reportFailure(error);
} finally {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
}

/** @param {Browser} browser */
async function openPage(browser) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  page.on('pageerror', (error) => process.stderr.write(`${error.message}\n`));
  if (values.drawn) return page;
  await page.addInitScript(() => {
    const prototype = /** @type {any} */ (WebGL2RenderingContext.prototype);
    for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced', 'clear']) {
      prototype[name] = () => {};
    }
  });
  return page;
}

/**
 * Renderers take turns, so that what else the machine does falls on all of them.
 * @param {Browser} browser
 * @param {number} count
 */
async function measureBodies(browser, count) {
  const options = { entryPoints: { main: 'bench/frame-cost/page.ts' }, outdir: '/', write: false };
  const { outputFiles } = await build(bundleOptions({ ...options, sourcemap: false, write: false }));
  const html = '<!doctype html><link rel="icon" href="data:,"><body><script type="module" src="./main.js"></script>';
  const files = new Map([['/index.html', Buffer.from(html)]]);
  for (const { contents } of outputFiles ?? []) files.set('/main.js', Buffer.from(contents));
  const server = await serveFiles({ find: (path) => files.get(path) });
  const candidates = [];
  for (const [renderer, dimensions] of /** @type {const} */ ([
    ['pixi', 2],
    ['three', 2],
    ['three', 3],
    ['ParticleContainer', 2],
  ])) {
    const page = await openPage(browser);
    await page.goto(server.url);
    await page.waitForFunction(() => '__open' in globalThis);
    const open = /** @param {any} given */ (given) => /** @type {any} */ (globalThis).__open(...given);
    await page.evaluate(open, [renderer, dimensions, count]);
    candidates.push({ name: `${renderer} ${dimensions}D`, page, times: /** @type {number[][]} */ ([]) });
  }
  for (let round = -1; round < ROUNDS; round++) {
    for (const { page, times } of candidates) {
      const frames = /** @param {number} n */ (n) => /** @type {any} */ (globalThis).__frames(n);
      const measured = await page.evaluate(frames, round < 0 ? WARM : FRAMES);
      if (round >= 0) times.push(...measured);
    }
  }
  for (const { name, page, times } of candidates) {
    const update = median(times.map(([time]) => time));
    const total = median(times.map(([first, second]) => first + second));
    process.stdout.write(`${count} bodies, ${name}: ${ms(total)}, of which update() ${ms(update)}\n`);
    await page.close();
  }
  await server.close();
}

/**
 * @param {Browser} browser
 * @param {string} site
 * @param {number} count
 */
async function measureSparks(browser, site, count) {
  for (const renderer of ['pixi', 'three']) {
    const frames = await watch(browser, `${site}fireworks/?barrage=true&sparks=${count}&renderer=${renderer}`);
    const alive = median(frames.map((frame) => frame[2]));
    process.stdout.write(`${alive} sparks, ${renderer}: ${parts(frames)}\n`);
  }
}

/**
 * Every game as a visitor finds it, in each renderer that it has.
 * @param {Browser} browser
 * @param {string} site
 */
async function measureGames(browser, site) {
  for (const name of gameNames()) {
    if (WITHOUT_SHELL.includes(name)) continue;
    process.stdout.write(`${name}: ${parts(await watch(browser, `${site}${gameAddress(name)}`))}\n`);
  }
}

/**
 * Frames of a game: milliseconds of steps and of drawing, and its particles.
 * @param {Browser} browser
 * @param {string} url
 */
async function watch(browser, url) {
  const page = await openPage(browser);
  await page.goto(url);
  await page.waitForFunction(() => /** @type {any} */ (globalThis).__game?.state().ready, undefined, { polling: 50 });
  const frames = await page.evaluate(watchGame, values.drawn ? 40 : 2 * GAME_WARM);
  await page.close();
  return frames;
}

/** @param {number[][]} frames */
function parts(frames) {
  const [step, draw] = [0, 1].map((i) => median(frames.map((frame) => frame[i])));
  return `${ms(step + draw)} (step ${ms(step)}, draw ${ms(draw)})`;
}

/** Runs in the page. @param {number} count @returns {Promise<number[][]>} of the second half of the frames */
async function watchGame(count) {
  const game = /** @type {any} */ (globalThis).__game;
  const seen = [];
  for (let i = 0; i < count; i++) {
    await new Promise((done) => requestAnimationFrame(done));
    if (i < count / 2) continue;
    const { timing, game: own } = game.state();
    seen.push([timing.step, timing.draw, own.alive]);
  }
  return seen;
}

/** @param {number[]} list */
function median(list) {
  return list.sort((a, b) => a - b)[list.length >> 1] ?? Number.NaN;
}

/** @param {number} time */
function ms(time) {
  return `${time.toFixed(2)} ms`;
}

/** @param {string} file */
function readIfThere(file) {
  try {
    return readFileSync(file);
  } catch {
    return undefined;
  }
}
