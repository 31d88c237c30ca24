import { findChromium } from './chromium.ts';

/** Finds or installs a browser once, so that no test file waits for it; without one the other tests still run. */
export function setup(): void {
  try {
    process.env.CHROMIUM = findChromium();
  } catch (error) {
    process.stderr.write(`${(error as Error).message}\n`);
  }
}
