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

test.each([
  [360, 640],
  [390, 844],
  [640, 360],
])(
  'the last button of the open panel can be tapped on a phone, and does not move the time: %d × %d',
  async (width, height) => {
    const context = await browser().newContext({ viewport: { width, height }, hasTouch: true });
    const page = await context.newPage();
    await page.goto(served.url);
    await page.waitForFunction(() => globalThis.__game?.state().ready);
    await page.evaluate(() => {
      __game.pause();
      __game.step(100);
    });
    await page.locator('.game-bar button[title^="Settings"]').tap();
    const button = page.locator('.game-side button', { hasText: 'Colour-blind palette' });
    await button.scrollIntoViewIfNeeded({ timeout: 5000 });
    await page.locator('.game-side').evaluate((panel) => panel.scrollTo(0, panel.scrollHeight));
    const middle = await button.boundingBox().then((box) => box && [box.x + box.width / 2, box.y + box.height / 2]);
    const before = await page.evaluate(() => __game.state());
    await page.touchscreen.tap(...(middle as [number, number]));
    const after = await page.evaluate(() => __game.state());
    expect([after.safeColors, after.tick]).toEqual([!before.safeColors, before.tick]);
    await context.close();
  },
);
