import { afterAll, beforeAll, expect, test } from 'vitest';
import { chaosHashes } from '../support/chaos.ts';
import { hingeHashes } from '../support/falling-hinges.ts';
import { openPage, type ServedPage, servePage } from '../support/page.ts';
import { sceneHashes } from '../support/scene-hashes.ts';
import { shareBrowser } from '../support/shared-browser.ts';

const browser = shareBrowser();
let served: ServedPage;

beforeAll(async () => {
  served = await servePage(new URL('./pages/determinism-page.ts', import.meta.url));
});

afterAll(() => served?.close());

test('chaotic worlds and every scene end in the same bits in Node and in Chromium', async () => {
  const { page, errors } = await openPage(browser(), served.url);
  const found = await page.evaluate('[chaosHashes(), sceneHashes()]');
  expect(errors).toEqual([]);
  expect(found).toEqual([chaosHashes(), sceneHashes()]);
  expect(await page.evaluate('hingeHashes()')).toEqual(hingeHashes());
  await page.close();
});
