/** Games in an element of a page, and games that stop: a page gets back all that a game took. */
import { readFileSync } from 'node:fs';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { countInPage, KEPT_BY_PIXI, objectsOf, takeCounts, WITHOUT_COMPILERS } from '../../scripts/lib/leak-watch.mjs';
import { type ServedPage, servePage } from '../support/page.ts';
import { shareBrowser } from '../support/shared-browser.ts';
import type {} from './mount.page.ts';

const HTML = `<input id="text"><div id="game" style="width: 640px; height: 400px"></div>
<div id="small" style="width: 340px; height: 420px"></div>`;

const browser = shareBrowser({ args: [WITHOUT_COMPILERS] });
let served: ServedPage;

beforeAll(async () => {
  served = await servePage(new URL('./mount.page.ts', import.meta.url), { html: HTML });
});

afterAll(() => served?.close());

async function open() {
  const page = await browser().newPage({ viewport: { width: 1000, height: 900 } });
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
  await page.addInitScript(countInPage);
  await page.goto(`${served.url}?tab=3`);
  await page.waitForFunction(() => globalThis.mountLab !== undefined);
  return { page, errors };
}

it('fills its element, and leaves the keys, the address and the look of the page to the page', async () => {
  const { page, errors } = await open();
  await page.evaluate(() => mountLab.start('#game').ready);
  expect(await page.evaluate(() => [__game.state().banner, getComputedStyle(document.body).overflow])).toEqual([
    '',
    'visible',
  ]);
  const canvas = page.locator('#game .game-stage canvas');
  expect(await canvas.boundingBox()).toEqual(await page.locator('#game').boundingBox());
  // An element as narrow as a phone has the buttons of one.
  await page.evaluate(() => mountLab.start('#small').ready);
  expect(await page.locator('#game .game-bar [data-minor]').first().isVisible()).toBe(true);
  expect(await page.locator('#small .game-bar [data-minor]').first().isVisible()).toBe(false);
  const paused = () => page.evaluate(() => __game.state().paused);
  await page.locator('#text').click();
  await page.keyboard.type(' s');
  expect([await page.locator('#text').inputValue(), await paused()]).toEqual([' s', false]);
  await page.locator('#game .game-stage canvas').click({ position: { x: 60, y: 300 } });
  await page.keyboard.press(' ');
  expect(await paused()).toBe(false);
  await page.locator('#small .game-stage canvas').click({ position: { x: 60, y: 300 } });
  await page.keyboard.press(' ');
  expect(await paused()).toBe(true);
  // A button that was pressed gives the focus back to its game.
  await page.locator('#small .game-bar button[title^="Resume"]').click();
  await page.keyboard.press(' ');
  expect(await paused()).toBe(true);
  await page.keyboard.press('ArrowUp');
  expect(await page.evaluate(() => __game.state().game)).toEqual({ pressed: ['up'] });
  expect(errors).toEqual([]);
  await page.close();
});

it('stops: no loop, no element, no hook, and twice is once', async () => {
  const { page, errors } = await open();
  await page.evaluate(() => mountLab.start().ready);
  await page.waitForFunction(() => __game.state().tick > 10);
  expect(await page.evaluate(() => getComputedStyle(document.body).overflow)).toBe('hidden');
  const steps = await page.evaluate(() => {
    const [{ stop }] = mountLab.running;
    stop();
    stop();
    return mountLab.steps();
  });
  await page.waitForTimeout(300);
  expect(await page.evaluate(() => mountLab.steps())).toBe(steps);
  const left = await page.evaluate(() => ({
    elements: document.querySelectorAll('.game, canvas').length,
    hook: '__game' in globalThis,
    overflow: getComputedStyle(document.body).overflow,
  }));
  expect(left).toEqual({ elements: 0, hook: false, overflow: 'visible' });
  expect(errors).toEqual([]);
  await page.close();
});

it('leaves nothing of twenty games, started and stopped by either renderer, of which some never opened', async () => {
  const { page, errors } = await open();
  const session = await page.context().newCDPSession(page);
  const mount = (count: number) =>
    page.evaluate(async (rounds) => {
      for (let i = 0; i < rounds; i++) {
        const running = mountLab.start(i % 2 === 0 ? '#game' : undefined, i % 4 < 2 ? '' : 'renderer=three');
        if (i % 5 === 4) running.stop();
        await running.ready;
        mountLab.stopAll();
        mountLab.forget();
      }
    }, count);
  await mount(20);
  const before = await takeCounts(page, session);
  await mount(20);
  const after = await takeCounts(page, session);
  expect([after.contexts, after.memories, objectsOf(after)]).toEqual([0, 0, 0]);
  expect(after.nodes).toBeLessThanOrEqual(before.nodes);
  expect(after.listeners).toBeLessThanOrEqual(before.listeners);
  expect(after.heap).toBeLessThan(before.heap + 20 * KEPT_BY_PIXI);
  expect(errors).toEqual([]);
  await page.close();
});

it('says that it needs an element', async () => {
  const { page } = await open();
  const said = await page.evaluate(() => {
    try {
      mountLab.start('#none');
    } catch (error) {
      return (error as Error).message;
    }
    return '';
  });
  expect(said).toContain('startGame needs an element as parent, or none for the whole page, got null');
  await page.close();
});

it('is styled under the Content-Security-Policy of the documentation', async () => {
  const guide = readFileSync('docs/in-your-own-project.md', 'utf8');
  const [, policy] = /Content-Security-Policy: (default-src .*)/.exec(guide) as RegExpExecArray;
  const html = `<!doctype html><html lang="en"><head><meta http-equiv="content-security-policy" content="${policy}">
    <title>Fall</title><link rel="icon" href="data:,"><script type="module" src="./main.js"></script></head></html>`;
  const strict = await servePage(new URL('./mount.page.ts', import.meta.url), { html });
  const page = await browser().newPage({ viewport: { width: 1000, height: 700 } });
  await page.addInitScript(() => {
    const blocked: string[] = [];
    document.addEventListener('securitypolicyviolation', (event) => blocked.push(event.effectiveDirective));
    Object.assign(globalThis, { blocked });
  });
  await page.goto(strict.url);
  await page.waitForFunction(() => globalThis.mountLab !== undefined);
  await page.evaluate(() => mountLab.start(undefined, 'renderer=three').ready);
  expect((await page.locator('.game-bar button').first().boundingBox())?.height).toBe(38);
  expect((await page.locator('.lil-gui .lil-slider').first().boundingBox())?.height).toBe(24);
  // The icon in `data:` is that of this page.
  const blocked = await page.evaluate(() => (globalThis as unknown as { blocked: string[] }).blocked);
  expect(blocked.filter((directive) => directive !== 'img-src')).toEqual([]);
  await page.close();
  await strict.close();
});
