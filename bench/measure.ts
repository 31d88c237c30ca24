// Times steps of ours and of peers in turns, A B A B, in one process: whatever slows the machine slows both alike, so
// ratios hold where milliseconds do not. Each peer has turns of its own, from the state the scene is in then; all at
// once they would push each other, and us, out of the cache.
import type { SceneRun } from '@principia/scenes';
import type { PeerMaker } from './peers/peer.ts';
import { median } from './statistics.ts';

export interface Measured {
  /** Milliseconds of our steps after the warm-up. */
  readonly ours: Float64Array;
  readonly peers: readonly { readonly name: string /** Their time over ours. */; readonly ratio: number }[];
}

export interface MeasureOptions {
  readonly steps: number;
  /** First steps that are not timed, while the compiler optimizes. */
  readonly warmup: number;
  readonly progress: (done: number) => void;
  /** Called at the end of the warm-up. */
  readonly onTimed?: () => void;
}

/** Fraction of a peer's steps that count as warm-up. */
const WARM_TURNS = 0.25;

export async function measureSteps(
  run: SceneRun,
  advance: () => void,
  makers: readonly PeerMaker[],
  { steps, warmup, progress, onTimed }: MeasureOptions,
): Promise<Measured> {
  const ours = new Float64Array(steps - warmup);
  const peers: Measured['peers'][number][] = [];
  for (let s = 0; s < warmup; s++) {
    advance();
    progress(s + 1);
  }
  onTimed?.();
  let done = 0;
  for (let p = 0; p < makers.length; p++) {
    const peer = await makers[p](run);
    if (peer === undefined) continue;
    const { name, step } = peer;
    const end = done + Math.floor((ours.length - done) / (makers.length - p));
    const theirs = new Float64Array(end - done);
    for (let turn = 0; turn < theirs.length; turn++) {
      ours[done + turn] = timed(advance);
      theirs[turn] = timed(step);
      progress(warmup + done + turn + 1);
    }
    peers.push({ name, ratio: ratioOf(theirs, ours.subarray(done, end)) });
    done = end;
  }
  for (; done < ours.length; done++) {
    ours[done] = timed(advance);
    progress(warmup + done + 1);
  }
  return { ours, peers };
}

/** Times after the first quarter. */
function ratioOf(theirs: Float64Array, ours: Float64Array): number {
  const cold = Math.floor(WARM_TURNS * theirs.length);
  return median(theirs.subarray(cold)) / median(ours.subarray(cold));
}

function timed(work: () => void): number {
  const start = performance.now();
  work();
  return performance.now() - start;
}
