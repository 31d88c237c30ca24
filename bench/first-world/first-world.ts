import type { Precision } from '@principia/physics';

/** Makes a page's first world and takes its first step. */
export type FirstWorld = (precision: Precision) => void;

/** Hands the function to `scripts/lib/first-world.mjs`, which calls it in the page. */
export function provideFirstWorld(start: FirstWorld): void {
  Object.assign(globalThis, { startFirstWorld: start });
}
