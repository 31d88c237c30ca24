// xoshiro128** 1.1 (Blackman and Vigna, Scrambled Linear Pseudorandom Number Generators, ACM TOMS 47, 2021): period
// 2^128 - 1, passes BigCrush. The state is four words of the world's memory. src/math/random.ts is the same generator
// in TypeScript, and seeds it.
import { logarithm } from './elementary';

// The next 32 random bits.
export function randomWord(state: usize): u32 {
  const s0 = load<u32>(state);
  const s1 = load<u32>(state, 4);
  const s2 = load<u32>(state, 8) ^ s0;
  const s3 = load<u32>(state, 12) ^ s1;
  store<u32>(state, s0 ^ s3);
  store<u32>(state, s1 ^ s2, 4);
  store<u32>(state, s2 ^ (s1 << 9), 8);
  store<u32>(state, rotl<u32>(s3, 11), 12);
  return rotl<u32>(s1 * 5, 7) * 9;
}

// Uniform in [0, 1), a multiple of 2^-32.
export function randomUnit(state: usize): f64 {
  return <f64>randomWord(state) * 2.3283064365386963e-10;
}

// Normal with mean 0 and variance 1, by Marsaglia's polar method (SIAM Review 6, 260, 1964). The second value is
// discarded, so that the four words are the whole state.
export function randomNormal(state: usize): f64 {
  let x: f64 = 0;
  let s: f64 = 0;
  do {
    x = 2 * randomUnit(state) - 1;
    const y = 2 * randomUnit(state) - 1;
    s = x * x + y * y;
  } while (s >= 1 || s == 0);
  return x * sqrt<f64>((-2 * logarithm(s)) / s);
}
