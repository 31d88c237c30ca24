/** Measures how long a page takes from the navigation to its first frame that can be played. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { writeSite } from './site-build.mjs';
import { serveFiles } from './static-server.mjs';

/** A browser that draws by the processor; `CHROMIUM` names it. */
export function launchBrowser() {
  const args = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  return chromium.launch({ executablePath, chromiumSandbox: false, args });
}

/** Builds the site and serves it. @param {string} folder for its files */
export async function serveBuilt(folder) {
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

/**
 * Milliseconds from the navigation to the end of the first frame after the game was ready for input.
 * @param {import('playwright-core').Page} page
 * @param {string} address of a page with a game of the shell
 * @returns {Promise<number>}
 */
export async function firstFrame(page, address) {
  await page.addInitScript(watchStart);
  await page.goto(address, { waitUntil: 'commit' });
  await page.waitForFunction(() => /** @type {any} */ (globalThis).__started);
  return page.evaluate(() => /** @type {any} */ (globalThis).__started);
}

/** The middle one. @param {readonly number[]} times */
export function medianOf(times) {
  return times.toSorted((a, b) => a - b)[times.length >> 1];
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
