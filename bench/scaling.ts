// The growth of the cost of a step with the count: the scene is created at several counts and a few steps are timed.
import type { SceneRun } from '@principia/scenes';
import { median } from './statistics.ts';

/** A count and the time of a step. */
export interface ScalingPoint {
  readonly count: number;
  readonly msPerStep: number;
  /** RMS relative error of approximated forces; null if forces are exact. */
  readonly rmsForceError: number | null;
}

const WARMUP = 3;
const TIMED = 5;

/** Counts from the first to the last, two per decade, rounded to two digits. */
export function countsBetween(from: number, to: number): number[] {
  const intervals = Math.max(1, Math.round(2 * Math.log10(to / from)));
  const count = (i: number) => Number((from * (to / from) ** (i / intervals)).toPrecision(2));
  return [from, ...Array.from({ length: intervals - 1 }, (_, i) => count(i + 1)), to];
}

export function measureScaling(
  create: (count: number) => SceneRun,
  counts: readonly number[],
  advanceOf: (run: SceneRun) => () => void,
  progress: (done: number) => void,
): ScalingPoint[] {
  return counts.map((count, done) => {
    const run = create(count);
    const advance = advanceOf(run);
    const times: number[] = [];
    for (let s = 0; s < WARMUP + TIMED; s++) {
      const start = performance.now();
      advance();
      if (s >= WARMUP) times.push(performance.now() - start);
    }
    progress(done + 1);
    return { count, msPerStep: median(times), rmsForceError: run.forceError?.(run.world) ?? null };
  });
}

/** The exponent p of cost = c N^p, by least squares of the logarithms. */
export function growthOf(points: readonly Pick<ScalingPoint, 'count' | 'msPerStep'>[]): number {
  const at = points.map(({ count, msPerStep }) => [Math.log(count), Math.log(msPerStep)] as const);
  const [meanX, meanY] = [0, 1].map((axis) => at.reduce((sum, point) => sum + point[axis], 0) / at.length);
  const along = at.reduce((sum, [x, y]) => sum + (x - meanX) * (y - meanY), 0);
  return along / at.reduce((sum, [x]) => sum + (x - meanX) ** 2, 0);
}
