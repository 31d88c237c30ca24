/** What a player sees of a world that cannot be made, and how the game goes on from there. */
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { type ServedPage, servePage } from '../support/page.ts';
import { shareBrowser } from '../support/shared-browser.ts';
import type {} from './failing-world.page.ts';

const browser = shareBrowser();
let served: ServedPage;

beforeAll(async () => {
  served = await servePage(new URL('./failing-world.page.ts', import.meta.url));
});

afterAll(() => served?.close());

async function open(failing: string): Promise<Page> {
  const page = await browser().newPage({ viewport: { width: 900, height: 600 } });
  page.setDefaultTimeout(60_000);
  await page.goto(`${served.url}?failing=${failing}`);
  return page;
}

const banner = (page: Page) => page.locator('.game-banner:not([hidden])');
const isReady = (page: Page) => page.waitForFunction(() => globalThis.__game?.state().ready);

it.each(['Restart', 'a setting'])('brings the picture with the first world that can be made: by %s', async (means) => {
  const page = await open('2');
  await banner(page).getByText('no room of 2 dimensions').waitFor();
  const change = async () => {
    if (means === 'Restart') return banner(page).getByRole('button', { name: 'Restart' }).click();
    await page.locator('.game-side input[type=number], .game-side .lil-number input').first().fill('0.2');
    await page.keyboard.press('Enter');
  };
  if (means === 'Restart') {
    await change();
    await banner(page).getByText('no room of 2 dimensions').waitFor();
  }
  await page.evaluate(() => failingLab.failing.splice(0));
  await change();
  await isReady(page);
  await page.waitForFunction(() => __game.state().tick > 3);
  expect(await page.locator('.game-stage canvas').count()).toBe(1);
  await page.close();
});

it('goes back to the renderer before, and says why, where the world of another cannot be made', async () => {
  const page = await open('3');
  await isReady(page);
  await page.locator('[data-renderer=three]').click();
  await banner(page).getByText('no room of 3 dimensions').waitFor();
  await isReady(page);
  const shown = () =>
    page.evaluate(() => ({
      renderer: __game.state().renderer,
      pressed: document.querySelector('[data-renderer][aria-pressed=true]')?.textContent,
      canvases: document.querySelectorAll('.game-stage canvas').length,
    }));
  expect(await shown()).toEqual({ renderer: 'pixi', pressed: '2D', canvases: 1 });
  await page.evaluate(() => failingLab.failing.splice(0));
  await page.locator('[data-renderer=three]').click();
  await page.waitForFunction(() => __game.state().ready && __game.state().renderer === 'three');
  expect(await shown()).toEqual({ renderer: 'three', pressed: '3D', canvases: 1 });
  expect(await banner(page).count()).toBe(0);
  await page.close();
});

it('shows a note below an error, which stays when the note leaves', async () => {
  const page = await open('3');
  await isReady(page);
  await page.locator('[data-renderer=three]').click();
  await banner(page).getByText('no room of 3 dimensions').waitFor();
  await isReady(page);
  const error = await page.evaluate(() => __game.state().banner);
  // Copying is refused: the page is not allowed to, and says so in a note.
  await page.locator('button[title*="link" i]').first().click();
  await page.waitForFunction((before) => __game.state().banner.startsWith(`${before}\n`), error);
  await page.mouse.move(5, 300);
  await page.waitForFunction((before) => __game.state().banner === before, error);
  expect(await banner(page).getByRole('button', { name: 'Restart' }).isVisible()).toBe(true);
  await page.close();
});

it('resumes by the space bar after the timeline was clicked, which keeps the arrow keys', async () => {
  const page = await open('');
  await isReady(page);
  await page.waitForFunction(() => __game.state().tick > 20);
  await page.locator('.game-timeline input').click({ position: { x: 30, y: 8 } });
  const { tick } = await page.evaluate(() => __game.state());
  expect(await page.evaluate(() => __game.state().paused)).toBe(true);
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction((before) => __game.state().tick > before, tick);
  await page.keyboard.press('Space');
  expect(await page.evaluate(() => __game.state().paused)).toBe(false);
  await page.close();
});
