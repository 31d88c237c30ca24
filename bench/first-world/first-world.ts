import type { Precision } from '@principia/physics';

/** Creates the first world of a page and takes its first step. */
export type FirstWorld = (precision: Precision) => void;

/** Exposes the function to `scripts/lib/first-world.mjs`, which calls it in the page. */
export function provideFirstWorld(start: FirstWorld): void {
  Object.assign(globalThis, { startFirstWorld: start });
}
