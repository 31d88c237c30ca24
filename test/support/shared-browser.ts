/**
 * A browser, and what is opened in it, for all tests of a file or of a `describe`. A test that is tried again gets a new
 * one: where the process that draws has hung or died, every later try in the same browser would fail with it.
 */
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, beforeEach } from 'vitest';
import { launchChromium } from './chromium.ts';

/** Runs `open` before the tests that follow, and again before each second try of one. */
export function beforeAllAndRetries(open: () => Promise<void>): void {
  beforeAll(open);
  beforeEach(async ({ task }) => {
    if ((task.result?.retryCount ?? 0) > 0) await open();
  });
}

/**
 * Starts a Chromium for the tests that follow and closes it after them. Call it before `beforeAll` or
 * `beforeAllAndRetries` opens anything in it.
 * @param options further flags of the browser
 * @returns gives the browser of the test that runs
 */
export function shareBrowser(options: { args?: readonly string[] } = {}): () => Browser {
  let browser: Browser | undefined;
  beforeAllAndRetries(async () => {
    await browser?.close();
    browser = await launchChromium(options);
  });
  afterAll(() => browser?.close());
  return () => browser as Browser;
}
