import { afterAll, beforeAll, expect, test } from 'vitest';
import { openPage, type ServedPage, servePage } from '../support/page.ts';
import { shareBrowser } from '../support/shared-browser.ts';

const browser = shareBrowser();
let served: ServedPage;

beforeAll(async () => {
  served = await servePage(new URL('./swapped-poses.page.ts', import.meta.url));
});

afterAll(() => served?.close());

test.each([
  ['pixi', 2, false],
  ['pixi', 2, true],
  ['three', 2, false],
  ['three', 3, false],
  ['three', 3, true],
] as const)(
  'after a step %s draws what a new layer would (%iD, context lost: %s)',
  async (renderer, dimensions, loses) => {
    const { page, errors } = await openPage(browser(), served.url);
    const pixels = await page.evaluate(
      (given) => globalThis.swapLab.stepBetween(given.renderer, given.dimensions, given.loses),
      { renderer, dimensions, loses },
    );
    expect(pixels.fresh).toBe(0);
    // Five bodies, each some ten pixels in radius, that move by their radius and more.
    expect(pixels.later).toBeGreaterThan(500);
    expect(pixels.before).toBeGreaterThan(500);
    expect(errors).toEqual([]);
    await page.close();
  },
);
