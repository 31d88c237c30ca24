// Memory use. All figures need `--expose-gc`; without it they are NaN instead of wrong.

const collect = (globalThis as { gc?: () => void }).gc;

/** Bytes of the JavaScript heap after a garbage collection. */
export function heapBytes(): number {
  if (collect === undefined) return Number.NaN;
  collect();
  return process.memoryUsage().heapUsed;
}

/**
 * Bytes in use: live objects on the heap, and whatever the process has in real memory outside the heap, such as the
 * pages of a world that were touched. Reserved but untouched pages cost nothing and are not counted.
 */
export function bytesInUse(): number {
  if (collect === undefined) return Number.NaN;
  collect();
  collect();
  const { heapUsed, heapTotal, rss } = process.memoryUsage();
  return heapUsed + rss - heapTotal;
}

/** Steps after which compilation has certainly finished, and the longest wait for it, ms. */
const PATIENCE = { steps: 2000, ms: 5000 };

/**
 * Bytes of garbage a step leaves on the heap once the compiler is done with it: the least growth over rounds of steps,
 * for the engine takes room for itself in some, a hundred kilobytes at once. Asking for the figure costs some bytes
 * itself; a round of no steps tells how many.
 */
export function garbageBytesPerStep(advance: () => void): number {
  const ROUNDS = 7;
  const STEPS = 20;
  const end = performance.now() + PATIENCE.ms;
  for (let s = 0; s < PATIENCE.steps && performance.now() < end; s++) advance();
  const growths: number[] = [];
  for (let round = 0; round < ROUNDS; round++) {
    const asking = growth(advance, 0);
    growths.push(Math.max(0, growth(advance, STEPS) - asking) / STEPS);
  }
  return Math.round(Math.min(...growths));
}

function growth(advance: () => void, steps: number): number {
  const before = heapBytes();
  for (let s = 0; s < steps; s++) advance();
  return process.memoryUsage().heapUsed - before;
}
