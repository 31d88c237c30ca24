// An emitter's record in the world's memory: the class of kernels/emitters/record.ts, field by field.
import type { Arena } from '../memory/arena.ts';

/** The maximum number of colour ramps of an emitter, and of stops of a ramp. */
export const MAX_RAMPS = 8;
export const MAX_STOPS = 4;

/** Indices of the u32 fields in `record.words`; a const enum, so that a bundle contains only the numbers. */
export const enum W {
  ids,
  generation,
  free,
  older,
  newer,
  bornAt,
  life,
  factor,
  ramp,
  colors,
  previousX,
  previousY,
  previousZ,
  color,
  size,
  generations,
  endedIds,
  endedAt,
  endedNow,
  bursts,
  burstCount,
  capacity,
  freeHead,
  freeCount,
  alive,
  oldest,
  newest,
  dimensions,
  recyclesOldest,
  emits,
  rampCount,
  sizeStops,
  changed,
  repaint,
  random0,
  random1,
  random2,
  random3,
  /** The stops of all ramps, and the number of stops of each. */
  color0,
  stops0 = color0 + 32,
  /** The number of words. */
  count = stops0 + 8,
}

/** Indices of the f64 fields in `record.numbers`, which follow the words. */
export const enum N {
  clock,
  pending,
  owed,
  /** The parameters in the order of `checkParameters`, the last of which are up to four sizes. */
  rate,
  lifeMin,
  lifeMax,
  speedMin,
  speedMax,
  directionX,
  directionY,
  directionZ,
  spread,
  areaX,
  areaY,
  areaZ,
  scatterX,
  scatterY,
  scatterZ,
  inheritVelocity,
  mass,
  factorMin,
  factorMax,
  size0,
  size1,
  size2,
  size3,
  cosSpread,
  radius,
  x,
  y,
  z,
  lastX,
  lastY,
  lastZ,
  velocityX,
  velocityY,
  velocityZ,
  born,
  ended,
  lost,
  /** The number of f64 fields. */
  count,
}

export const RECORD_BYTES = W.count * 4 + N.count * 8;

export interface EmitterRecord {
  readonly at: number;
  readonly words: Uint32Array;
  readonly numbers: Float64Array;
}

export function recordAt({ memory }: Arena, at: number): EmitterRecord {
  return {
    at,
    words: new Uint32Array(memory.buffer, at, W.count),
    numbers: new Float64Array(memory.buffer, at + W.count * 4, N.count),
  };
}
