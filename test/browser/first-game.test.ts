/** Plays the first game through its real page: taps that hit the ball count, until it touches the floor. */
import type { Page } from 'playwright-core';
import { PNG } from 'pngjs';
import { expect, it } from 'vitest';
import { playGame } from '../support/game-page.ts';

const { open } = playGame('first-game', { viewport: { width: 640, height: 400 }, until: 'nothing' });

/** The middle of the orange pixels. */
async function ballPlace(page: Page) {
  const { data, width } = PNG.sync.read(await page.screenshot());
  let [x, y, count] = [0, 0, 0];
  for (let i = 0; i < data.length / 4; i++) {
    const [r, g, b] = data.subarray(4 * i, 4 * i + 3);
    if (r < 200 || g < 120 || b > 130) continue;
    x += i % width;
    y += Math.floor(i / width);
    count++;
  }
  return { x: x / count, y: y / count, count };
}

it('counts hits, keeps the best, and begins anew at the floor', async () => {
  const page = await open();
  const text = () => page.locator('output').textContent();
  await page.waitForFunction(() => document.querySelector('output')?.textContent?.startsWith('Tap the ball'));
  // The ball moves while the picture is taken, so a tap may miss.
  for (let tries = 0; tries < 20 && !/^[1-9]/.test((await text()) ?? ''); tries++) {
    const { x, y, count } = await ballPlace(page);
    expect(count).toBeGreaterThan(100);
    await page.mouse.click(x, y);
    await page.waitForTimeout(50);
  }
  await page.waitForFunction(() => /best: [1-9]/.test(document.querySelector('output')?.textContent ?? ''));
  await page.reload();
  await page.waitForFunction(() => /best: [1-9]/.test(document.querySelector('output')?.textContent ?? ''));
  expect(await page.locator('a[aria-label="All games"]').getAttribute('href')).toBe('../index.html');
});
