/** What games hold must not grow, whatever is done to them: the short form of `npm run leaks`. */
import { readFileSync } from 'node:fs';
import { expect, it, onTestFinished } from 'vitest';
import { countInPage, objectsOf, playRound, takeCounts, WITHOUT_COMPILERS } from '../../scripts/lib/leak-watch.mjs';
import { servePage } from '../support/page.ts';
import { shareBrowser } from '../support/shared-browser.ts';

const browser = shareBrowser({ args: [WITHOUT_COMPILERS] });

/** Rounds until caches are full, and then enough to tell a leak in each from what comes and goes. */
const WARM = 4;
const ROUNDS = 10;
/** A round takes 2 to 10 s, by what else the machine does, because code runs unoptimised. */
const TIMEOUT = 300_000;
/** What the browser learns of code comes and goes; a leak of a world leaves one or more a round, 70 KB each at least. */
const SLACK = 1e6;

/** Two hundred shaded balls are many for a graphics card that is a program; leaks do not depend on their number. */
const games = [
  ['bouncing-balls', '&renderer=pixi&count=5&collisions=off'],
  ['black-hole', ''],
  ['fireworks', ''],
] as const;

it.each(games)('%s lets go of what it no longer needs', { timeout: TIMEOUT }, async (game, query) => {
  const html = readFileSync(`games/${game}/index.html`, 'utf8');
  const served = await servePage(`games/${game}/main.ts`, { html });
  const page = await browser().newPage({ viewport: { width: 400, height: 300 } });
  onTestFinished(async () => {
    await page.close();
    await served.close();
  });
  await page.addInitScript(countInPage);
  const session = await page.context().newCDPSession(page);
  await page.goto(`${served.url}?manual${query}`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  for (let round = 0; round < WARM; round++) await playRound(page, round);
  const before = await takeCounts(page, session);
  for (let round = WARM; round < WARM + ROUNDS; round++) await playRound(page, round);
  const after = await takeCounts(page, session);
  expect(before.contexts).toBeGreaterThan(0);
  expect(objectsOf(before)).toBeGreaterThan(10);
  expect(objectsOf(after)).toBeLessThanOrEqual(objectsOf(before));
  // One may wait for the collector at a count; a leak leaves one or more a round.
  expect(after.contexts).toBeLessThan(before.contexts + ROUNDS / 2);
  expect(after.memories).toBeLessThan(before.memories + ROUNDS / 2);
  // The labels of a plot come and go by a few.
  expect(after.nodes).toBeLessThan(before.nodes + ROUNDS);
  expect(after.listeners).toBeLessThan(before.listeners + ROUNDS);
  expect(after.heap).toBeLessThan(before.heap + SLACK);
});
