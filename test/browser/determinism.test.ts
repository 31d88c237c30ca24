import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { chaosHashes } from '../support/chaos.ts';
import { launchChromium } from '../support/chromium.ts';
import { hingeHashes } from '../support/falling-hinges.ts';
import { openPage, type ServedPage, servePage } from '../support/page.ts';

let browser: Browser;
let served: ServedPage;

beforeAll(async () => {
  [browser, served] = await Promise.all([
    launchChromium(),
    servePage(new URL('./pages/determinism-page.ts', import.meta.url)),
  ]);
});

afterAll(async () => {
  await browser?.close();
  await served?.close();
});

test('a chaotic scene ends in the same bits in Node and in Chromium', async () => {
  const { page, errors } = await openPage(browser, served.url);
  const found = await page.evaluate('chaosHashes()');
  expect(errors).toEqual([]);
  expect(found).toEqual(chaosHashes());
  expect(await page.evaluate('hingeHashes()')).toEqual(hingeHashes());
  await page.close();
});
