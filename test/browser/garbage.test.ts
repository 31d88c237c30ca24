/** A game that runs makes no objects: whatever a frame needs was made before. */
import { readFileSync } from 'node:fs';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { writeShow } from '../../games/fireworks/show.ts';
import { allocations, type Site, takeOverFrames } from '../../scripts/lib/garbage-watch.mjs';
import { launchChromium } from '../support/chromium.ts';
import { servePage } from '../support/page.ts';

let browser: Browser;

beforeAll(async () => {
  // Functions are compiled to the end after fewer calls: the state of a game that has run for minutes.
  const flags = ['--interrupt-budget=5000', '--invocation-count-for-turbofan=100', '--max-semi-space-size=64'];
  browser = await launchChromium({ args: [`--js-flags=${flags.join(' ')}`] });
});

afterAll(() => browser?.close());

const WARM = 3000;
const FRAMES = 300;
/** Objects a frame of a site that count: three a second. What is rarer is no frame's. */
const OFTEN = 0.05;
/** A show of one shell is over when the frames are counted; what goes on is the barrage. */
const SHOW = `#show=${writeShow([{ tick: 0, x: 0, y: 30, z: 0, kind: 0, color: 0, power: 0.5 }])}`;
const games = [
  ['fireworks in 2D', 'fireworks', `?barrage=true&sparks=2000&renderer=pixi${SHOW}`],
  ['fireworks in 3D', 'fireworks', `?barrage=true&sparks=2000&renderer=three${SHOW}`],
  ['bouncing balls in 2D', 'bouncing-balls', '?count=200&trails=true&renderer=pixi'],
  ['bouncing balls in 3D', 'bouncing-balls', '?count=200&trails=true&renderer=three'],
] as const;

const text = ({ place, objects, bytes }: Site) => `${place}: ${objects.toFixed(2)} objects, ${bytes.toFixed(0)} bytes`;

it.each(games)('%s: no object a frame', async (_, game, query) => {
  const html = readFileSync(`games/${game}/index.html`, 'utf8');
  const served = await servePage(`games/${game}/main.ts`, { html });
  const page = await browser.newPage({ viewport: { width: 900, height: 300 } });
  await page.addInitScript(takeOverFrames);
  const session = await page.context().newCDPSession(page);
  await page.goto(`${served.url}${query}`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  // The panel has figures in words, new ones five times a second.
  await page.keyboard.press('p');
  const sourceMap = await sourceMapOf(served.url);
  const sites = await allocations(page, session, { warm: WARM, frames: FRAMES, sourceMap });
  const ours = sites.filter(({ isOurs, objects }) => isOurs && objects > OFTEN);
  if (process.env.GARBAGE)
    process.stdout.write(
      `${_}\n${sites
        .slice(0, 60)
        .map((s) => `  ${text(s)}, ${s.numbers.toFixed(0)} of numbers`)
        .join('\n')}\n`,
    );
  await page.close();
  await served.close();
  expect(ours.map(text)).toEqual([]);
  // The profiler sees what there is to see: renderers make objects of their own.
  expect(sites.some(({ isOurs, objects }) => !isOurs && objects > OFTEN)).toBe(true);
});

/** The map that `servePage` appends to the script. */
async function sourceMapOf(url: string): Promise<string> {
  const script = await (await fetch(`${url}main.js`)).text();
  const [, data] = script.split('sourceMappingURL=data:application/json;base64,');
  return Buffer.from(data, 'base64').toString();
}
