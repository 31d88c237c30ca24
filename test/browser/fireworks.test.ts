/** Plays the fireworks through their real page: mouse, fingers, keys, and the address. */
import { readFileSync } from 'node:fs';
import { step } from '@principia/physics';
import type { LoggedInput } from '@principia/scenes';
import type { GameState } from '@principia/shell';
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { PNG } from 'pngjs';
import { afterAll, afterEach, beforeAll, describe, expect, it } from 'vitest';
import { DEMO_SHOW } from '../../games/fireworks/demo-show.ts';
import { createGame, type Input } from '../../games/fireworks/sim.ts';
import { launchChromium } from '../support/chromium.ts';
import { type ServedPage, servePage } from '../support/page.ts';

const VALUES = { wind: 0, safe: false, barrage: false, sparks: 100_000 };

/** What the game tells of itself. */
interface Told {
  readonly hash: string;
  readonly log: LoggedInput<Input>[];
  readonly alive: number;
  readonly fired: number;
}

let browser: Browser;
let served: ServedPage;
let context: BrowserContext;
let errors: string[] = [];

beforeAll(async () => {
  const html = readFileSync('games/fireworks/index.html', 'utf8');
  served = await servePage('games/fireworks/main.ts', { html });
  browser = await launchChromium();
});

afterAll(async () => {
  await browser?.close();
  await served?.close();
});

afterEach(async () => {
  await context?.close();
  const seen = errors;
  errors = [];
  expect(seen).toEqual([]);
});

async function play(query: string, size = { width: 640, height: 400 }): Promise<Page> {
  context = await browser.newContext({ viewport: size, hasTouch: true });
  const page = await context.newPage();
  page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
  await page.goto(`${served.url}?${query}`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  return page;
}

const state = (page: Page): Promise<GameState> => page.evaluate(() => __game.state());
const told = async (page: Page) => (await state(page)).game as unknown as Told;
const steps = (page: Page, count: number) => page.evaluate((n) => __game.step(n), count);

/** Steps with a picture after each few, so that light can gather. */
const watch = (page: Page, count: number) =>
  page.evaluate(async (n) => {
    for (let i = 0; i < n; i += 3) {
      __game.step(3);
      await new Promise((done) => requestAnimationFrame(done));
    }
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  }, count);

/** Pixels of the sky that are as bright as only sparks are, and how many of them are coloured rather than white. */
async function brightness(page: Page) {
  const shot = await page.screenshot({ style: '.game > :not(.game-stage) { display: none }' });
  const { data, width, height } = PNG.sync.read(shot);
  const found = { bright: 0, colored: 0 };
  for (let i = 0; i < width * Math.floor(0.7 * height); i++) {
    const [r, g, b] = data.subarray(4 * i, 4 * i + 3);
    const most = Math.max(r, g, b);
    if (most < 150) continue;
    found.bright++;
    if (most - Math.min(r, g, b) > 70) found.colored++;
  }
  return found;
}

describe.each(['pixi', 'three'])('in %s', (renderer) => {
  it('a click sends up a shell that fills the sky with coloured light, and the log plays it again in Node', async () => {
    const page = await play(`manual&seed=5&renderer=${renderer}`);
    // The demo, which nobody has interrupted yet.
    await steps(page, 6);
    const dark = await brightness(page);
    await page.mouse.click(320, 130);
    await steps(page, 150);
    expect((await told(page)).fired).toBe(1);
    await watch(page, 60);
    const lit = await brightness(page);
    expect(dark.bright).toBeLessThan(60);
    expect(lit.bright).toBeGreaterThan(400);
    expect(lit.colored).toBeGreaterThan(0.3 * lit.bright);
    const { hash, log } = await told(page);
    const dimensions = renderer === 'pixi' ? 2 : 3;
    const again = createGame({ values: VALUES, seed: 5, dimensions, opening: DEMO_SHOW, log });
    for (let i = (await state(page)).tick; i > 0; i--) step(again.world, again.dt);
    expect(again.hash()).toBe(hash);
  });
});
