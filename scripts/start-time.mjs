/**
 * How long players wait: from the click on a game to its first frame that can be played, in milliseconds. Each load is
 * in a fresh browser that has shown the front page, as players come from there; nothing is in its cache.
 *
 * `npm run start-time -- [--loads 5] [--game black-hole] [--built]`; `--built` serves the site of `npm run build` in
 * place of that of `npm start`. `CHROMIUM` names the browser. Times are this machine's, drawn by its processor.
 */
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { commandOptions } from './lib/command-options.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { writeSite } from './lib/site-build.mjs';
import { gameNames } from './lib/site-pages.mjs';
import { serveSite } from './lib/site-server.mjs';
import { serveFiles } from './lib/static-server.mjs';

const values = commandOptions({
  loads: { type: 'string', default: '5' },
  game: { type: 'string', multiple: true },
  built: { type: 'boolean', default: false },
});

const folder = mkdtempSync(join(tmpdir(), 'principia-start-'));
try {
  const server = values.built ? await serveBuilt() : await serveSite({ ports: [0], host: '127.0.0.1' });
  // The first game of the tour has no shell to say when it is ready.
  const names = values.game ?? gameNames().filter((name) => name !== 'first-game');
  await untilServed(`${server.url}${names[0]}/main.js`);
  for (const name of names) {
    /** @type {number[]} */
    const times = [];
    for (let i = 0; i < Number(values.loads); i++) times.push(await firstFrame(server.url, name));
    times.sort((a, b) => a - b);
    const all = times.map((time) => time.toFixed(0)).join(' ');
    process.stdout.write(`${name}: ${times[times.length >> 1].toFixed(0)} ms (${all})\n`);
  }
  await server.close();
} catch (error) {
  await reportFailure(error);
} finally {
  rmSync(folder, { recursive: true, force: true });
}
process.exit();

async function serveBuilt() {
  await writeSite(folder);
  return serveFiles({
    find(path) {
      try {
        return readFileSync(join(folder, path));
      } catch {
        return undefined;
      }
    },
  });
}

/** @param {string} address a script that is there when the first bundle is made */
async function untilServed(address) {
  for (let i = 0; i < 600; i++) {
    if ((await fetch(address)).ok) return;
    await new Promise((done) => setTimeout(done, 100));
  }
  throw new Error(`Nothing is served at ${address} after a minute: does “npm start” work?`);
}

/**
 * Milliseconds from the navigation to the end of the first frame after the game was ready for input.
 * @param {string} url of the site
 * @param {string} name
 */
async function firstFrame(url, name) {
  const args = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  const browser = await chromium.launch({ executablePath, chromiumSandbox: false, args });
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.goto(url);
  await page.waitForTimeout(1000);
  await page.addInitScript(watchStart);
  await page.goto(`${url}${name}/`, { waitUntil: 'commit' });
  await page.waitForFunction(() => /** @type {any} */ (globalThis).__started);
  const time = await page.evaluate(() => /** @type {any} */ (globalThis).__started);
  await browser.close();
  return time;
}

/** Runs in the page: games put `__game` there when they can be played. */
function watchStart() {
  /** @type {unknown} */
  let game;
  Object.defineProperty(globalThis, '__game', {
    configurable: true,
    get: () => game,
    set(made) {
      game = made;
      requestAnimationFrame(() => {
        // Behind everything that this frame still does.
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () => Object.assign(globalThis, { __started: performance.now() });
        port2.postMessage(0);
      });
    },
  });
}
