/** The submarine through its real page: it dives by keys and by touch, and its sonar answers. */
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { fingersOf, frames, playGame, state, steps } from '../support/game-page.ts';

const { open } = playGame('submarine', { viewport: { width: 900, height: 600 } });

interface Report {
  readonly depth: number;
  readonly fill: number;
  readonly pingTime: number;
  readonly ending: string;
}

const told = async (page: Page) => (await state(page)).game as unknown as Report;

it('dives while the key is held, pings', async () => {
  const page = await open('manual');
  await page.keyboard.down('ArrowDown');
  await steps(page, 120);
  await page.keyboard.up('ArrowDown');
  await steps(page, 120);
  expect((await told(page)).fill).toBeCloseTo(0.4 + 0.44, 2);
  expect((await told(page)).depth).toBeGreaterThan(8);
  await page.keyboard.press('x');
  expect((await told(page)).pingTime).toBeGreaterThan(3.9);
  await frames(page);
  await page.keyboard.down('ArrowUp');
  await steps(page, 240);
  expect((await told(page)).fill).toBeLessThan(0.1);
  expect((await state(page)).banner).toBe('');
});

it('dives by the touch pad of a phone', async () => {
  const page = await open('manual', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const box = await page.locator('.game-pad [data-name=down]').boundingBox();
  const { x, y } = box as { x: number; y: number };
  const touch = await fingersOf(page);
  await touch('touchStart', [{ x: x + 20, y: y + 20 }]);
  await steps(page, 60);
  await touch('touchEnd');
  await steps(page, 60);
  expect((await told(page)).fill).toBeCloseTo(0.4 + 0.22, 2);
});

it.each([
  [1280, 800],
  [390, 844],
  [844, 390],
  [768, 1024],
  [1024, 768],
])('keeps its gauges off the ship and the touch pad in a window of %i by %i', async (width, height) => {
  const touch = { hasTouch: true, isMobile: true };
  const page = await open('manual', { viewport: { width, height }, ...(width < 1200 ? touch : {}) });
  await frames(page);
  const gauges = (await page.locator('.sub-panel').boundingBox()) as {
    x: number;
    y: number;
    width: number;
    height: number;
  };
  const { y } = (await page.evaluate(() => __game.body(0).screen)) as { y: number };
  // The ship reaches 10 m above the water and 2 m below, and a metre takes at most ten pixels here.
  expect(gauges.y + gauges.height < y - 110 || gauges.y > y + 40).toBe(true);
  expect(gauges.y + gauges.height).toBeLessThanOrEqual(height);
  const buttons = await page.locator('.game-pad :is(button, .game-stick):visible').all();
  expect(buttons.length > 0).toBe(width < 1200);
  for (const button of buttons) {
    const box = (await button.boundingBox()) as typeof gauges;
    const isBeside = box.x + box.width <= gauges.x || gauges.x + gauges.width <= box.x;
    const isAbove = box.y + box.height <= gauges.y || gauges.y + gauges.height <= box.y;
    expect(isBeside || isAbove).toBe(true);
  }
});
