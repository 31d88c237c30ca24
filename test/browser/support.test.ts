import { afterAll, beforeAll, expect, test } from 'vitest';
import { openPage, type ServedPage, servePage } from '../support/page.ts';
import { shareBrowser } from '../support/shared-browser.ts';

const browser = shareBrowser();
let served: ServedPage;

beforeAll(async () => {
  served = await servePage(new URL('../support/fixtures/page-entry.ts', import.meta.url));
});

afterAll(() => served?.close());

test('a test page is isolated and has WebGL', async () => {
  const { page, errors } = await openPage(browser(), served.url);
  expect(await page.title()).toBe('isolated=true webgl=true');
  expect(errors).toEqual([]);
  await page.close();
});

test('a test page has a WebGPU adapter', async () => {
  const { page } = await openPage(browser(), served.url);
  const adapter = await page.evaluate('navigator.gpu.requestAdapter().then((adapter) => adapter !== null)');
  expect(adapter).toBe(true);
  await page.close();
});
