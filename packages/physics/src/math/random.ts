// Seeded random numbers: xoshiro128** 1.1 (Blackman and Vigna, Scrambled Linear Pseudorandom Number Generators, ACM
// TOMS 47, 2021). kernels/math/random.ts is the same generator and uses the same four words.
import { checkWhole, type Vector } from '../errors/validate.ts';
import { log } from './elementary.ts';

/** A stream of random numbers. The same seed gives the same stream on every machine. */
export interface Random {
  /** Four words: the complete state of the generator. Copy them to save it, write them to restore it. */
  readonly state: Uint32Array;
  /** The next 32 random bits, as an unsigned integer. */
  word(): number;
  /** Uniform in [min, max), by default [0, 1); one of 2³² equally spaced values. */
  uniform(min?: number, max?: number): number;
  /** A uniformly distributed integer from `min` to `max`, both included. @throws PhysicsError E_TYPE, E_RANGE */
  integer(min: number, max: number): number;
  /** −1 or 1. */
  sign(): number;
  /** Normally distributed, by default with mean 0 and standard deviation 1. */
  gaussian(mean?: number, deviation?: number): number;
  /** A point on the circle about the origin in the x-y plane, uniform in angle. */
  onCircle(radius?: number): Vector;
  /** A point on the sphere about the origin, uniform in area. */
  onSphere(radius?: number): Vector;
  /**
   * Returns another generator seeded from this one: a separate stream for code that draws an unknown number of times.
   */
  split(): Random;
}

/**
 * Creates a seeded generator.
 * @param seed integer from 0 to 2⁵³ − 1
 * @param stream distinguishes generators of one seed: 0, 1, 2…
 * @throws PhysicsError E_TYPE, E_NONFINITE, E_RANGE
 */
export function createRandom(seed: number, stream = 0): Random {
  checkWhole(seed, 'seed', 0, 2 ** 53 - 1);
  checkWhole(stream, 'stream', 0, 2 ** 32 - 1);
  const state = new Uint32Array(4);
  seedWords(state, seed, stream);
  return generator(state);
}

/** Fills the four words of a generator from a seed and a stream number. */
export function seedWords(state: Uint32Array, seed: number, stream: number): void {
  const low = mix((seed >>> 0) ^ mix(stream));
  const high = mix(Math.floor(seed / 2 ** 32) + mix(stream ^ 0x5bd1e995));
  // Each word depends on the one before it, so that all of the seed affects every word: the first number drawn depends
  // on the second word only.
  let word = mix(low + GOLDEN);
  state[0] = word;
  word = mix((high ^ word) + 2 * GOLDEN);
  state[1] = word;
  word = mix((low ^ word) + 3 * GOLDEN);
  state[2] = word;
  state[3] = mix((stream ^ word) + 4 * GOLDEN);
  if (state.every((word) => word === 0)) state[0] = 1;
}

/** 2³² divided by the golden ratio. */
const GOLDEN = 0x9e3779b9;

/** A bijection of 32 bits in which every input bit flips half of the output bits (Wellons, lowbias32, 2018). */
export function mix(value: number): number {
  let z = value | 0;
  z = Math.imul(z ^ (z >>> 16), 0x21f0aaad);
  z = Math.imul(z ^ (z >>> 15), 0x735a2d97);
  return (z ^ (z >>> 15)) >>> 0;
}

function rotate(word: number, by: number): number {
  return (word << by) | (word >>> (32 - by));
}

/** The generator step. */
function nextWord(state: Uint32Array): number {
  const s0 = state[0] as number;
  const s1 = state[1] as number;
  const s2 = (state[2] as number) ^ s0;
  const s3 = (state[3] as number) ^ s1;
  state[0] = s0 ^ s3;
  state[1] = s1 ^ s2;
  state[2] = s2 ^ (s1 << 9);
  state[3] = rotate(s3, 11);
  return Math.imul(rotate(Math.imul(s1, 5), 7), 9) >>> 0;
}

function generator(state: Uint32Array): Random {
  const unit = () => nextWord(state) * 2 ** -32;
  return {
    state,
    word: () => nextWord(state),
    uniform: (min = 0, max = 1) => min + (max - min) * unit(),
    integer: (min, max) => drawInteger(state, min, max),
    sign: () => (nextWord(state) >= 2 ** 31 ? 1 : -1),
    gaussian: (mean = 0, deviation = 1) => mean + deviation * normal(unit),
    onCircle: (radius = 1) => onCircle(unit, radius),
    onSphere: (radius = 1) => onSphere(unit, radius),
    split() {
      const child = new Uint32Array(4);
      const low = nextWord(state);
      seedWords(child, low + (nextWord(state) >>> 11) * 2 ** 32, nextWord(state));
      return generator(child);
    },
  };
}

/** Draws that would bias the result towards smaller numbers are rejected. */
function drawInteger(state: Uint32Array, min: number, max: number): number {
  checkWhole(min, 'min', -Number.MAX_VALUE, Number.MAX_VALUE);
  checkWhole(max, 'max', min, min + 2 ** 32 - 1);
  const count = max - min + 1;
  const fair = 2 ** 32 - (2 ** 32 % count);
  for (;;) {
    const word = nextWord(state);
    if (word < fair) return min + (word % count);
  }
}

/**
 * Marsaglia's polar method (SIAM Review 6, 260, 1964); the second value is discarded, so that `state` is the complete
 * state.
 */
function normal(unit: () => number): number {
  for (;;) {
    const x = 2 * unit() - 1;
    const y = 2 * unit() - 1;
    const s = x * x + y * y;
    if (s < 1 && s > 0) return x * Math.sqrt((-2 * log(s)) / s);
  }
}

/** Von Neumann (1951): the double angle of a point in the disc, without a sine. */
function onCircle(unit: () => number, radius: number): Vector {
  for (;;) {
    const x = 2 * unit() - 1;
    const y = 2 * unit() - 1;
    const s = x * x + y * y;
    if (s < 1 && s > 0) return { x: (radius * (x * x - y * y)) / s, y: (radius * 2 * x * y) / s, z: 0 };
  }
}

/** Marsaglia, Annals of Mathematical Statistics 43, 645 (1972). */
function onSphere(unit: () => number, radius: number): Vector {
  for (;;) {
    const x = 2 * unit() - 1;
    const y = 2 * unit() - 1;
    const s = x * x + y * y;
    if (s >= 1) continue;
    const scale = 2 * radius * Math.sqrt(1 - s);
    return { x: x * scale, y: y * scale, z: radius * (1 - 2 * s) };
  }
}
