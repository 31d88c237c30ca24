// An emitter's record in the world's memory: the class of kernels/emitters/record.ts, field by field.
import type { Arena } from '../store/arena';

/** Colour ramps an emitter can choose from, and stops of a ramp. */
export const MOST_RAMPS = 8;
export const MOST_STOPS = 4;

const numbered = (name: string, count: number) => Array.from({ length: count }, (_, i) => `${name}${i}`);

const WORD_NAMES = [
  'ids',
  'generation',
  'free',
  'older',
  'newer',
  'bornAt',
  'life',
  'factor',
  'ramp',
  'colors',
  'previousX',
  'previousY',
  'previousZ',
  'color',
  'size',
  'generations',
  'endedIds',
  'endedAt',
  'endedNow',
  'bursts',
  'burstCount',
  'capacity',
  'freeHead',
  'freeCount',
  'alive',
  'oldest',
  'newest',
  'dimensions',
  'recyclesOldest',
  'emits',
  'rampCount',
  'sizeStops',
  'changed',
  'repaint',
  'random0',
  'random1',
  'random2',
  'random3',
] as const;

/** The u32 fields, in order. */
export const WORDS: readonly string[] = [
  ...WORD_NAMES,
  ...numbered('color', MOST_RAMPS * MOST_STOPS),
  ...numbered('stops', MOST_RAMPS),
];

/** The f64 fields, in order, behind the words. */
export const NUMBERS = [
  'clock',
  'pending',
  'owed',
  'rate',
  'lifeMin',
  'lifeMax',
  'speedMin',
  'speedMax',
  'directionX',
  'directionY',
  'directionZ',
  'spread',
  'cosSpread',
  'x',
  'y',
  'z',
  'lastX',
  'lastY',
  'lastZ',
  'velocityX',
  'velocityY',
  'velocityZ',
  'areaX',
  'areaY',
  'areaZ',
  'scatterX',
  'scatterY',
  'scatterZ',
  'mass',
  'radius',
  'factorMin',
  'factorMax',
  'size0',
  'size1',
  'size2',
  'size3',
  'born',
  'ended',
  'lost',
] as const;

type Numbers = { readonly [Name in (typeof NUMBERS)[number]]: number };
type Words = { readonly [Name in (typeof WORD_NAMES)[number] | 'color0' | 'stops0']: number };

/** Where a field stands in `record.words`. */
export const W = Object.fromEntries(WORDS.map((name, index) => [name, index])) as unknown as Words;

/** Where a field stands in `record.numbers`. */
export const N = Object.fromEntries(NUMBERS.map((name, index) => [name, index])) as unknown as Numbers;

export const RECORD_BYTES = WORDS.length * 4 + NUMBERS.length * 8;

export interface EmitterRecord {
  readonly at: number;
  readonly words: Uint32Array;
  readonly numbers: Float64Array;
}

export function recordAt({ memory }: Arena, at: number): EmitterRecord {
  return {
    at,
    words: new Uint32Array(memory.buffer, at, WORDS.length),
    numbers: new Float64Array(memory.buffer, at + WORDS.length * 4, NUMBERS.length),
  };
}
