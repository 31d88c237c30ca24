/**
 * How long each example of the laboratory takes to open, in milliseconds from the navigation to its first drawn frame:
 * the median of all, the slowest, and those above a second. Each load has a cache of its own, which is empty. The site is
 * that of `npm run build`, served by this machine, so that what remains is the page's own work.
 *
 * `npm run open-time -- [--loads 3] [--only ch16] [--slowest 10] [--delay 0]`; `--only` takes the examples whose id contains
 * a text, `--delay` adds milliseconds to every answer of the server, as a network does. `CHROMIUM` names the browser. Times
 * are this machine's, drawn by its processor: compare those of one run.
 */
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { SingleBar } from 'cli-progress';
import { exampleFiles } from './build-examples.mjs';
import { commandOptions, numberOption } from './lib/command-options.mjs';
import { firstFrame, launchBrowser, medianOf, serveBuilt } from './lib/first-frame.mjs';
import { reportFailure } from './lib/report-failure.mjs';

const values = commandOptions({
  loads: { type: 'string', default: '3' },
  only: { type: 'string', default: '' },
  slowest: { type: 'string', default: '10' },
  delay: { type: 'string', default: '0' },
});
const loads = numberOption('loads', values.loads, { min: 1 });
const slowest = numberOption('slowest', values.slowest, { min: 0 });
const delay = numberOption('delay', values.delay, { min: 0, whole: false });
/** Milliseconds above which a page is listed. */
const SLOW = 1000;

const folder = mkdtempSync(join(tmpdir(), 'principia-open-'));
try {
  await measure();
} catch (error) {
  await reportFailure(error);
} finally {
  rmSync(folder, { recursive: true, force: true });
}
process.exit();

async function measure() {
  const ids = exampleFiles().map((file) => file.replace('/', '-').replace(/\.ts$/, ''));
  const chosen = ids.filter((id) => id.includes(values.only));
  if (chosen.length === 0) throw new Error(`--only ${values.only} names no example: ids are like ${ids[0]}.`);
  const server = await serveBuilt(folder);
  const browser = await launchBrowser();
  const bar = new SingleBar({ format: '{bar} {value} of {total} pages | {id} | {eta} s left', clearOnComplete: true });
  bar.start(chosen.length, 0, { id: '' });
  const times = [];
  // The first page of a browser waits for more than its own work.
  await load(browser, server.url, chosen[0]);
  for (const id of chosen) {
    const all = [];
    for (let i = 0; i < loads; i++) all.push(await load(browser, server.url, id));
    times.push({ id, time: medianOf(all) });
    bar.increment(1, { id });
  }
  bar.stop();
  await browser.close();
  await server.close();
  print(times);
}

/**
 * @param {import('playwright-core').Browser} browser
 * @param {string} site
 * @param {string} id
 */
async function load(browser, site, id) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, serviceWorkers: 'block' });
  const page = await context.newPage();
  if (delay > 0) {
    await page.route('**/*', async (route) => {
      await new Promise((done) => setTimeout(done, delay));
      await route.continue();
    });
  }
  const time = await firstFrame(page, `${site}laboratory/?example=${id}`);
  await context.close();
  return time;
}

/** @param {readonly { id: string, time: number }[]} times */
function print(times) {
  const sorted = times.toSorted((a, b) => b.time - a.time);
  /** @param {{ id: string, time: number }} each */
  const row = ({ id, time }) => `  ${time.toFixed(0).padStart(6)} ms  ${id}\n`;
  process.stdout.write(`${times.length} pages, median ${medianOf(times.map(({ time }) => time)).toFixed(0)} ms\n`);
  process.stdout.write(`The slowest:\n${sorted.slice(0, slowest).map(row).join('')}`);
  const slow = sorted.filter(({ time }) => time > SLOW);
  process.stdout.write(slow.length === 0 ? `None above ${SLOW} ms\n` : `Above ${SLOW} ms:\n${slow.map(row).join('')}`);
}
