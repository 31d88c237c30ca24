// A scheme against one that is next to exact: how far it strays, and what part of the time it takes. Both go to one time
// after another in turns, in one process, so that the ratio holds on a busy machine.
import type { ReferenceRuns } from '@principia/scenes';
import { median } from './statistics.ts';

export interface ReferenceResult {
  /** The reference. */
  readonly name: string;
  /** Our time over that of the reference: the median of the turns. */
  readonly timeRatio: number;
  /** Distance from it, km, by body and time. */
  readonly errorKm: Readonly<Record<string, Readonly<Record<string, number>>>>;
  /** The largest of all bodies and times at which one ended its turn, km. */
  readonly worstKm: number;
}

/** The first turns are slow, as they are compiled meanwhile; the median of all is of those that are not. */
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
