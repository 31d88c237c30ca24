import { findChromium } from './chromium.ts';

/** Finds or installs a browser once, so that no test file waits for it, and hands its path on. */
export function setup(): void {
  process.env.CHROMIUM = findChromium();
}
