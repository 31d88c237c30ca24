/** What views do when their world is replaced, when reduced motion is asked for, and when a picture cannot be painted. */
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type ServedPage, servePage } from '../support/page.ts';
import { shareBrowser } from '../support/shared-browser.ts';
import type {} from './view-refresh.page.ts';

const browser = shareBrowser();
let served: ServedPage;

beforeAll(async () => {
  served = await servePage(new URL('./view-refresh.page.ts', import.meta.url));
});

afterAll(() => served?.close());

async function open(query: string) {
  const page = await browser().newPage({ viewport: { width: 800, height: 600 } });
  await page.goto(`${served.url}?${query}`);
  return page;
}

describe.each(['pixi', 'three'])('the view by %s', (renderer) => {
  it('fits the new world until the player has taken the camera', async () => {
    const page = await open(`renderer=${renderer}&tab=1`);
    await page.waitForFunction(() => globalThis.__game?.state().ready);
    const before = await page.evaluate(() => viewLab.corner());
    await page.evaluate(() => __game.set('size', 20));
    expect(await page.evaluate(() => viewLab.corner())).toEqual(before);
    await page.close();
  });

  it('leaves no canvas behind where its picture cannot be painted', async () => {
    const page = await open(`renderer=${renderer}&tab=fails`);
    await page.getByText('no picture yet').waitFor();
    expect(await page.locator('.game-stage canvas').count()).toBe(0);
    await page.getByRole('button', { name: 'Try again' }).click();
    await page.locator('.game-stage canvas').waitFor();
    expect(await page.locator('.game-stage canvas').count()).toBe(1);
    await page.close();
  });
});

it('stops a 3D camera with the pointer as soon as reduced motion is asked for', async () => {
  const page = await open('renderer=three&tab=1');
  await page.waitForFunction(() => globalThis.__game?.state().ready);
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.waitForFunction(() => __game.state().reducedMotion);
  await page.mouse.move(100, 500);
  await page.mouse.down();
  await page.mouse.move(180, 500, { steps: 4 });
  await page.mouse.up();
  const frames = (count: number) =>
    page.evaluate(async (n) => {
      for (let i = 0; i < n; i++) await new Promise(requestAnimationFrame);
      return viewLab.camera();
    }, count);
  const first = await frames(2);
  expect(first[0]).not.toBeCloseTo(0, 1);
  expect(await frames(10)).toEqual(first);
  await page.close();
});
