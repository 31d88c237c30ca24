/** Plays the first game through its real page: hits count, until the ball touches the floor. */
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { playGame } from '../support/game-page.ts';
import { fingerOf, MEANS, mouseOf, tap } from '../support/hands.ts';

const { open } = playGame('first-game', { viewport: { width: 640, height: 400 }, until: 'nothing' });

/** Pictures of the page, and its time, come only when the bot asks for them: a busy machine changes nothing. */
function stopTime(): void {
  let now = 0;
  let waiting: FrameRequestCallback[] = [];
  performance.now = () => now;
  globalThis.requestAnimationFrame = (callback) => waiting.push(callback);
  Object.assign(globalThis, {
    passFrames(count: number) {
      for (let i = 0; i < count; i++) {
        now += 1000 / 60;
        const due = waiting;
        waiting = [];
        for (const callback of due) callback(now);
      }
    },
  });
}

/** Lets pictures pass. @returns the middle of the orange pixels of the last one, CSS pixels */
const watch = (page: Page, count: number) =>
  page.evaluate((count) => {
    (globalThis as unknown as { passFrames(count: number): void }).passFrames(count);
    const canvas = document.querySelector('canvas') as HTMLCanvasElement;
    const { width, height } = canvas;
    const copy = new OffscreenCanvas(width, height).getContext('2d') as OffscreenCanvasRenderingContext2D;
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, width, height);
    let [x, y, pixels] = [0, 0, 0];
    for (let i = 0; i < data.length / 4; i++) {
      if (data[4 * i] < 200 || data[4 * i + 1] < 120 || data[4 * i + 2] > 130) continue;
      x += i % width;
      y += Math.floor(i / width);
      pixels++;
    }
    return { x: x / pixels, y: y / pixels, pixels };
  }, count);

const text = (page: Page) => page.evaluate(() => document.querySelector('output')?.textContent ?? '');

const start = async (page: Page) => {
  const isThere = () => page.evaluate(() => document.querySelector('canvas') !== null);
  await expect.poll(isThere, { timeout: 30_000 }).toBe(true);
  await expect.poll(() => watch(page, 1), { timeout: 30_000 }).toMatchObject({ pixels: expect.any(Number) });
};

it.each(MEANS)('counts hits by %s, keeps the best, and begins anew at the floor', async (means) => {
  const page = await open('', { hasTouch: means === 'touch', prepare: stopTime });
  await start(page);
  expect(await text(page)).toContain('best: 0');
  const pointer = means === 'touch' ? await fingerOf(page) : mouseOf(page);
  let height = 0;
  for (let tries = 0; tries < 400 && (await text(page)) !== '3'; tries++) {
    const ball = await watch(page, 3);
    expect(ball.pixels).toBeGreaterThan(100);
    const isFalling = ball.y > height;
    height = ball.y;
    // The room of 9 m has 360 pixels above the floor at y 380; 3 m is where the space bar begins to count.
    const isLow = isFalling && ball.y > 270 && ball.y < 340;
    if (isLow) await (means === 'keys' ? page.keyboard.press('Space') : tap(pointer, ball));
  }
  expect(await text(page)).toBe('3');
  for (let tries = 0; tries < 100 && !(await text(page)).endsWith('best: 3'); tries++) await watch(page, 3);
  expect(await text(page)).toMatch(/^Tap the ball.* best: 3$/);
  await page.reload();
  await start(page);
  expect(await text(page)).toMatch(/^Tap the ball.* best: 3$/);
  expect(await page.locator('a[aria-label="All games"]').getAttribute('href')).toBe('../index.html');
});

it('speaks German where the browser does, and takes that of the address along', async () => {
  const page = await open('', { prepare: stopTime, locale: 'de-AT' });
  await start(page);
  expect(await text(page)).toMatch(/^Tippe auf den Ball.*Leertaste.* Rekord: 0$/);
  expect(await page.title()).toBe('Halt ihn oben');
  const asked = await open('lang=de', { prepare: stopTime, hasTouch: true, isMobile: true });
  await start(asked);
  expect(await text(asked)).toBe('Tippe auf den Ball – Rekord: 0');
  expect(await asked.locator('a').getAttribute('href')).toMatch(/index\.html\?lang=de$/);
});

it('is not won by holding the space bar, and a press too early begins anew', async () => {
  const page = await open('', { prepare: stopTime });
  await start(page);
  let best = 0;
  for (let i = 0; i < 100; i++) {
    await page.keyboard.down('Space');
    await watch(page, 3);
    best = Math.max(best, Number.parseInt(await text(page), 10) || 0);
  }
  expect(best).toBeLessThan(2);
});

it('can be begun with the space bar when the ball lies on the floor', async () => {
  const page = await open('', { prepare: stopTime });
  await start(page);
  // A fall of 5.5 m and all bounces at 0.8 of the speed take (1 + 2 · 0.8 / 0.2) √(2 · 5.5 / 9.81) < 10 s.
  await watch(page, 20 * 60);
  await page.keyboard.press('Space');
  await watch(page, 10);
  expect(await text(page)).toBe('1');
});

it('plays, and keeps the best as long as the page, where the browser keeps nothing', async () => {
  const page = await open('', { prepare: stopTime });
  await page.addInitScript(() => {
    const get = () => {
      throw new DOMException('Not allowed.', 'SecurityError');
    };
    Object.defineProperty(globalThis, 'localStorage', { get });
  });
  await page.reload();
  await start(page);
  expect(await text(page)).toContain('best: 0');
  await watch(page, 20 * 60);
  await page.keyboard.press('Space');
  await watch(page, 10);
  expect(await text(page)).toBe('1');
  for (let tries = 0; tries < 100 && !(await text(page)).includes('best'); tries++) await watch(page, 3);
  expect(await text(page)).toContain('best: 1');
});

it('runs in the page that the README shows, and finds the ball where the canvas is not in the corner', async () => {
  const [, html] = /## A complete game[\s\S]*?```html\n([\s\S]*?)```/.exec(readFileSync('README.md', 'utf8')) ?? [];
  const page = await open('', { prepare: stopTime });
  await page.route('**/*', (route) =>
    route.request().isNavigationRequest()
      ? route.fulfill({ body: html ?? '', contentType: 'text/html; charset=utf-8' })
      : route.continue(),
  );
  await page.reload();
  await start(page);
  expect(await text(page)).toBe('Tap the ball, or press Space as it falls low – best: 0');
  await page.addStyleTag({ content: 'canvas { position: absolute; left: 90px; top: 60px }' });
  const ball = await watch(page, 1);
  await page.mouse.click(ball.x, ball.y);
  await watch(page, 1);
  expect(await text(page)).toContain('best: 0');
  const moved = await watch(page, 1);
  await page.mouse.click(90 + moved.x, 60 + moved.y);
  await watch(page, 1);
  expect(await text(page)).toBe('1');
});
