// Times steps of ours and of peers in turns, A B A B, in one process: whatever slows the machine slows all alike, so
// ratios hold where milliseconds do not.
import type { Peer } from './peers/peer';

export interface Measured {
  /** Milliseconds of our steps after the warm-up. */
  readonly ours: Float64Array;
  /** The same for each peer. */
  readonly peers: readonly Float64Array[];
}

export interface MeasureOptions {
  readonly steps: number;
  /** First steps that are run and not kept: the compiler is still at work. */
  readonly warmup: number;
  readonly progress: (done: number) => void;
  /** Called when the warm-up is over. */
  readonly onTimed?: () => void;
}

export function measureSteps(advance: () => void, peers: readonly Peer[], options: MeasureOptions): Measured {
  const { steps, warmup, progress, onTimed } = options;
  const ours = new Float64Array(steps - warmup);
  const others = peers.map(() => new Float64Array(steps - warmup));
  for (let s = 0; s < steps; s++) {
    if (s === warmup) onTimed?.();
    const kept = s - warmup;
    const time = timed(advance);
    if (kept >= 0) ours[kept] = time;
    for (let p = 0; p < peers.length; p++) {
      const peerTime = timed((peers[p] as Peer).step);
      if (kept >= 0) (others[p] as Float64Array)[kept] = peerTime;
    }
    progress(s + 1);
  }
  return { ours, peers: others };
}

function timed(work: () => void): number {
  const start = performance.now();
  work();
  return performance.now() - start;
}
