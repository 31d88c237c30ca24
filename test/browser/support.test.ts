import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { launchChromium } from '../support/chromium.ts';
import { openPage, type ServedPage, servePage } from '../support/page.ts';

let browser: Browser;
let served: ServedPage;

beforeAll(async () => {
  [browser, served] = await Promise.all([
    launchChromium(),
    servePage(new URL('../support/fixtures/page-entry.ts', import.meta.url)),
  ]);
});

afterAll(async () => {
  await browser?.close();
  await served?.close();
});

test('a test page is isolated and has WebGL', async () => {
  const { page, errors } = await openPage(browser, served.url);
  expect(await page.title()).toBe('isolated=true webgl=true');
  expect(errors).toEqual([]);
  await page.close();
});

test('a test page has a WebGPU adapter', async () => {
  const { page } = await openPage(browser, served.url);
  const adapter = await page.evaluate('navigator.gpu.requestAdapter().then((adapter) => adapter !== null)');
  expect(adapter).toBe(true);
  await page.close();
});
