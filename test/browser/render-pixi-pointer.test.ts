import type { Page } from 'playwright-core';
import { afterAll, beforeAll, beforeEach, expect, it } from 'vitest';
import { openPage, type ServedPage, servePage } from '../support/page.ts';
import { shareBrowser } from '../support/shared-browser.ts';

const browser = shareBrowser();
let served: ServedPage;
let page: Page;
let errors: string[];

beforeAll(async () => {
  served = await servePage(new URL('./render-pixi-pointer.page.ts', import.meta.url));
});

// The box is 400 by 300 pixels and shows 20 by 15 metres; the body lies at the origin, in the middle.
beforeEach(async () => {
  ({ page, errors } = await openPage(browser(), served.url));
  await page.waitForFunction(() => 'pixiPointerLab' in globalThis);
});

afterAll(async () => {
  await served?.close();
  expect(errors).toEqual([]);
});

const state = () => page.evaluate(() => pixiPointerLab.state());

it('drags a body with the mouse, also when the pointer leaves the canvas', async () => {
  await page.mouse.move(210, 150);
  await page.mouse.down();
  await page.mouse.move(300, 100, { steps: 5 });
  await page.mouse.move(600, 100, { steps: 5 });
  await page.mouse.up();
  const seen = await state();
  expect(seen.x).toBeCloseTo(20, 5);
  expect(seen.y).toBeCloseTo(2.5, 5);
  expect(seen.log.map(([name]) => name)).toEqual(['grab', 'release']);
  expect(seen.camera.x).toBe(0);
});

it('pans with the right button and zooms about the pointer with the wheel', async () => {
  await page.mouse.move(20, 20);
  await page.mouse.down({ button: 'right' });
  await page.mouse.move(60, 20);
  await page.mouse.up({ button: 'right' });
  expect((await state()).camera.x).toBeCloseTo(-2, 5);
  await page.mouse.wheel(0, -300);
  await page.waitForFunction(() => pixiPointerLab.state().camera.pixelsPerMetre > 20);
  const { camera } = await state();
  expect(camera.x + (60 - 200) / camera.pixelsPerMetre).toBeCloseTo(-2 - 140 / 20, 5);
});

it('pinches with two fingers and does not scroll the page', async () => {
  const session = await page.context().newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: number[][]) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
  await touch('touchStart', [
    [100, 50],
    [300, 50],
  ]);
  await touch('touchMove', [
    [50, 50],
    [350, 50],
  ]);
  await touch('touchEnd', []);
  const { camera } = await state();
  expect(camera.pixelsPerMetre).toBeCloseTo(30, 3);
  expect(camera.x).toBeCloseTo(0, 5);
});

it('follows the size of its box, also through nothing', async () => {
  for (const width of ['0px', '500px']) {
    await page.evaluate((w) => {
      pixiPointerLab.box.style.width = w;
    }, width);
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  }
  expect((await state()).sizes).toEqual([
    [400, 300, 1],
    [500, 300, 1],
  ]);
});
