/** The bar of the recorded time lies below the picture of a game, on wide windows and on phones. */
import { afterAll, beforeAll, expect, test } from 'vitest';
import { type ServedPage, servePage } from '../support/page.ts';
import { shareBrowser } from '../support/shared-browser.ts';
import type {} from './timeline.page.ts';

const browser = shareBrowser();
let served: ServedPage;

beforeAll(async () => {
  served = await servePage(new URL('./timeline.page.ts', import.meta.url));
});

afterAll(() => served?.close());

/** Opens the game and measures where its floor and the top of the bar are, CSS pixels from the top of the window. */
async function placesIn(
  width: number,
  height: number,
  query: string,
): Promise<{ floor: number; bar: number | undefined }> {
  const context = await browser().newContext({ viewport: { width, height } });
  const page = await context.newPage();
  const errors: string[] = [];
  page.on('pageerror', (error) => errors.push(error.stack ?? error.message));
  await page.goto(`${served.url}${query}`);
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  const places = await page.evaluate(() => ({
    floor: timelineLab.floor() ?? Number.NaN,
    bar: document.querySelector('.game-timeline')?.getBoundingClientRect().top,
  }));
  expect(errors).toEqual([]);
  await context.close();
  return places;
}

/** What the view leaves free about its bounds, CSS pixels. */
const MARGIN = 18;

test.each([
  [1000, 650],
  [740, 360],
  [390, 844],
])('the floor of a game is above the bar, and at the bottom of a game without one: %d × %d', async (width, height) => {
  const { floor, bar } = await placesIn(width, height, '');
  expect(bar).toBe(height - 44);
  expect(floor).toBeLessThanOrEqual(height - 44 - MARGIN + 0.5);
  const bare = await placesIn(width, height, '?bare');
  expect(bare.bar).toBeUndefined();
  // On a window on its side the height limits the scale, and the floor is at the margin.
  if (width > height) expect(bare.floor).toBeCloseTo(height - MARGIN, 0);
  expect(bare.floor).toBeGreaterThan(floor);
});
