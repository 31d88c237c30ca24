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
