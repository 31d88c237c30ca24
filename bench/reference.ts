// A scheme against one that is next to exact: how far it strays, and what part of the time it takes. Both go to one time
// after another in turns, in one process, so that the ratio holds on a busy machine.
import type { ReferenceRuns } from '@principia/scenes';
import { median } from './statistics.ts';

export interface ReferenceResult {
  /** Name of the reference integrator. */
  readonly name: string;
  /** Our time over that of the reference: the median of all intervals. */
  readonly timeRatio: number;
  /** Distance from the reference, km, by body and time. */
  readonly errorKm: Readonly<Record<string, Readonly<Record<string, number>>>>;
  /** The largest distance of any body at the end of any interval, km. */
  readonly worstKm: number;
}

/** The first intervals are slow because of compilation; the median ignores them. */
export function compareWithReference({ name, times, labels, ours, theirs, apartKm }: ReferenceRuns): ReferenceResult {
  const errorKm: Record<string, Record<string, number>> = {};
  const ratios: number[] = [];
  let worstKm = 0;
  for (const time of times) {
    const start = performance.now();
    ours(time);
    const between = performance.now();
    theirs(time);
    ratios.push((between - start) / (performance.now() - between));
    const apart = Object.entries(apartKm());
    worstKm = Math.max(worstKm, ...apart.map(([, distance]) => distance));
    const label = labels.get(time);
    if (label !== undefined)
      for (const [body, distance] of apart) errorKm[body] = { ...errorKm[body], [label]: distance };
  }
  return { name, timeRatio: median(ratios), errorKm, worstKm };
}
