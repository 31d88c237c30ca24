/**
 * How long the first world of a page blocks it: a fresh browser compiles and runs the script of `bench/first-world`, in
 * which bitECS and the physics are bundled, makes a world and takes a step. Fetching the script is not part of it.
 */
import { build } from 'esbuild';
import { bundleOptions } from './bundle.mjs';
import { serveFiles } from './static-server.mjs';

export const FIRST_WORLDS = ['particles', 'contacts', 'all-features'];

/** @typedef {{ script: number, world: number }} Blocked milliseconds: to run the script, then to make a world and step */

/**
 * A server of the pages.
 * @returns {Promise<import('./static-server.mjs').RunningServer>}
 */
export async function serveFirstWorlds() {
  const { outputFiles } = await build({
    ...bundleOptions({ format: 'iife', minify: true, sourcemap: false }),
    entryPoints: FIRST_WORLDS.map((name) => `bench/first-world/${name}.ts`),
    outdir: '/',
    write: false,
  });
  const files = new Map(outputFiles.map(({ path, contents }) => [path.replaceAll('\\', '/'), contents]));
  files.set('/index.html', Buffer.from('<!doctype html><link rel="icon" href="data:,"><body>'));
  return serveFiles({ find: (path) => files.get(path) });
}

/**
 * @param {import('playwright-core').Browser} browser one that has not shown the page yet
 * @param {string} url of the server
 * @param {string} name one of `FIRST_WORLDS`
 * @param {'f32' | 'f64'} precision
 * @returns {Promise<Blocked>}
 */
export async function blockedByFirstWorld(browser, url, name, precision) {
  const page = await browser.newPage();
  await page.goto(url);
  await page.waitForTimeout(500);
  return page.evaluate(startWorld, { address: `./${name}.js`, precision });
}

/**
 * Runs in the page. A script element that is given its text runs at once.
 * @param {{ address: string, precision: string }} options
 * @returns {Promise<Blocked>}
 */
async function startWorld({ address, precision }) {
  const text = await (await fetch(address)).text();
  const script = Object.assign(document.createElement('script'), { textContent: text });
  const began = performance.now();
  document.head.append(script);
  const ran = performance.now();
  /** @type {any} */ (globalThis).startFirstWorld(precision);
  return { script: ran - began, world: performance.now() - ran };
}
