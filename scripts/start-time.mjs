/**
 * How long players wait, in milliseconds, and what of that the physics takes: first how long the first world of a page
 * blocks it, then the time from the click on a game to its first frame that can be played. Each load is in a fresh
 * browser, for games one that has shown the front page, as players come from there; nothing is in its cache.
 *
 * `npm run start-time -- [--loads 5] [--worlds] [--game black-hole] [--built]`; `--worlds` leaves the games out, `--game`
 * the worlds; `--built` serves the site of `npm run build` in place of that of `npm start`. `CHROMIUM` names the browser.
 * Times are this machine's, drawn by its processor.
 */
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { buildKernels } from './build-kernels.mjs';
import { commandOptions, gamesOption, numberOption } from './lib/command-options.mjs';
import { firstFrame, launchBrowser, medianOf, serveBuilt } from './lib/first-frame.mjs';
import { blockedByFirstWorld, FIRST_WORLDS, serveFirstWorlds } from './lib/first-world.mjs';
import { reportFailure } from './lib/report-failure.mjs';
import { gameAddress, gameNames } from './lib/site-pages.mjs';
import { serveSite } from './lib/site-server.mjs';

const values = commandOptions({
  loads: { type: 'string', default: '5' },
  worlds: { type: 'boolean', default: false },
  game: { type: 'string', multiple: true },
  built: { type: 'boolean', default: false },
});
const loads = numberOption('loads', values.loads, { min: 1 });
// The first game of the tour has no shell to say when it is ready.
const games = gamesOption(
  values.game,
  gameNames().filter((name) => name !== 'first-game'),
);

const folder = mkdtempSync(join(tmpdir(), 'principia-start-'));
try {
  if (values.game === undefined) await measureWorlds();
  if (!values.worlds) await measureGames();
} catch (error) {
  await reportFailure(error);
} finally {
  rmSync(folder, { recursive: true, force: true });
}
process.exit();

async function measureWorlds() {
  await buildKernels();
  const server = await serveFirstWorlds();
  for (const name of FIRST_WORLDS) {
    for (const precision of /** @type {const} */ (['f64', 'f32'])) {
      const blocked = [];
      for (let i = 0; i < loads; i++) {
        const browser = await launchBrowser();
        blocked.push(await blockedByFirstWorld(browser, server.url, name, precision));
        await browser.close();
      }
      const [script, world] = [blocked.map((times) => times.script), blocked.map((times) => times.world)];
      const all = blocked.map((times) => times.script + times.world);
      const parts = `script ${medianOf(script).toFixed(1)}, world and step ${medianOf(world).toFixed(1)}`;
      process.stdout.write(`First world, ${name}, ${precision}: ${summary(all, 1)}; ${parts}\n`);
    }
  }
  await server.close();
}

async function measureGames() {
  const server = values.built ? await serveBuilt(folder) : await serveSite({ ports: [0], host: '127.0.0.1' });
  await untilServed(`${server.url}${games[0]}/main.js`);
  for (const name of games) {
    const times = [];
    for (let i = 0; i < loads; i++) times.push(await timeOf(server.url, name));
    process.stdout.write(`${name}: ${summary(times, 0)}\n`);
  }
  await server.close();
}

/**
 * The median, and all that it is the median of.
 * @param {readonly number[]} times
 * @param {number} digits behind the point
 */
function summary(times, digits) {
  const sorted = times.toSorted((a, b) => a - b).map((time) => time.toFixed(digits));
  return `${medianOf(times).toFixed(digits)} ms (${sorted.join(' ')})`;
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
 * From the front page, as players come.
 * @param {string} url of the site
 * @param {string} name
 */
async function timeOf(url, name) {
  const browser = await launchBrowser();
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.goto(url);
  await page.waitForTimeout(1000);
  const time = await firstFrame(page, `${url}${gameAddress(name)}`);
  await browser.close();
  return time;
}
