import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { openPage, type ServedPage, servePage } from '../support/page.ts';
import { beforeAllAndRetries, shareBrowser } from '../support/shared-browser.ts';
import type {} from './render-pixi-garbage.page.ts';

const browser = shareBrowser({ args: ['--enable-precise-memory-info', '--js-flags=--expose-gc'] });
let served: ServedPage;
let page: Page;
let errors: string[];

beforeAll(async () => {
  served = await servePage(new URL('./render-pixi-garbage.page.ts', import.meta.url));
});

beforeAllAndRetries(async () => {
  ({ page, errors } = await openPage(browser(), served.url));
  await page.waitForFunction(() => 'garbageOf' in globalThis);
});

afterAll(async () => {
  await served?.close();
  expect(errors).toEqual([]);
});

it('leaves no garbage when it uploads', async () => {
  const bytes = await page.evaluate(() => garbageOf(2000, 2000));
  expect(bytes).toBeLessThan(16);
});
