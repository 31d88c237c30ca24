// An emitter's record in the world's memory: the class of kernels/emitters/record.ts, field by field.
import type { Arena } from '../memory/arena.ts';

/** Colour ramps an emitter can choose from, and stops of a ramp. */
export const MAX_RAMPS = 8;
export const MAX_STOPS = 4;

/** Where the u32 fields stand in `record.words`, in order; a bundle has the numbers alone. */
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
  /** The stops of all ramps, and how many each has. */
  color0,
  stops0 = color0 + 32,
  /** How many words there are. */
  count = stops0 + 8,
}

/** Where the f64 fields stand in `record.numbers`, which follow the words. */
export const enum N {
  clock,
  pending,
  owed,
  /** What an emitter is told, in the order of `checkParameters`; up to four sizes, which are the end of it. */
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
  /** How many there are. */
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
