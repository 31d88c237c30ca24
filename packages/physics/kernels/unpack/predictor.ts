// Guesses the bits of a byte from what followed the same contexts before, and learns from each.
//
// Every context has a slot for each bit; it holds the probability of a 1, less a half, in its upper 12 bits, and how
// often it was met in the lower 4. The guesses are added in the logistic domain with weights that learn as well
// (logistic mixing: M. Mahoney, Adaptive Weighing of Context Models for Lossless Data Compression, Florida Tech
// CS-2005-16). Arithmetic is + − × ÷ alone, so what one machine packed every other unpacks.
import { bit } from './coder';
import { CHOICES, CHOSEN, CONTEXTS, CONTEXT_SLOTS, GUESSES, HELD, INPUTS, SQUASH, STRETCH, WEIGHTS } from './memory';

/** Times a slot counts: its rate of learning falls no further, since code changes its ways. */
const LONGEST_MEMORY = 15;
const LEARNING_RATE: f32 = 0.004;
const FIRST_WEIGHT: f32 = 0.083;
const BIAS: f32 = 0.3;
const HALF: f32 = 2048;
/** The logistic function is tabulated from −12 to 12 by 64ths. */
const REACH: f32 = 12;
const STEPS: f32 = 64;
const MIDDLE: i32 = 12 * 64;
const ROOT: f64 = 1.0157477085866857; // e to the power of 1/64

export function prepareTables(): void {
  let power: f64 = 1;
  for (let i = 0; i <= MIDDLE; i++) {
    store<f32>(SQUASH + ((MIDDLE + i) << 2), <f32>(power / (1 + power)));
    store<f32>(SQUASH + ((MIDDLE - i) << 2), <f32>(1 / (1 + power)));
    power *= ROOT;
  }
  let below = 0;
  for (let i = 0; i < 4096; i++) {
    const p: f32 = (<f32>i + 0.5) / 4096;
    while (squashed(below + 1) < p) below++;
    const part = (p - squashed(below)) / (squashed(below + 1) - squashed(below));
    store<f32>(STRETCH + (i << 2), (<f32>below + part) / STEPS - REACH);
  }
  for (let i = 0; i < CHOICES * 256 * INPUTS; i++) store<f32>(WEIGHTS + (i << 2), FIRST_WEIGHT);
  store<f32>(GUESSES + (CONTEXTS << 2), BIAS);
}

// @ts-ignore: decorator
@inline function squashed(index: i32): f32 {
  return load<f32>(SQUASH + (index << 2));
}

/** Which of its 256 sets of weights a choice takes for the next byte. */
export function choose(choice: i32, set: i32): void {
  store<usize>(CHOSEN + (choice << 2), WEIGHTS + ((((choice << 8) | (set & 255)) * INPUTS) << 2));
}

/**
 * The next byte, by the contexts that were hashed and the weights that were chosen. Where a byte is `expected` (one less
 * than it says), a first bit tells whether it is that, which spares the others.
 */
export function nextByte(expected: i32): i32 {
  if (expected > 0 && nextBit(255 + expected, expected - 1) != 0) return expected - 1;
  let node: u32 = 1;
  while (node < 256) node = 2 * node + nextBit(node, -1);
  return node - 256;
}

function nextBit(node: u32, expected: i32): u32 {
  for (let k: usize = 0; k < (<usize>CONTEXTS) << 2; k += 4) {
    const held = <i32>load<i16>(slotOf(k, node));
    store<i32>(HELD + k, held);
    store<f32>(GUESSES + k, load<f32>(STRETCH + (((held >> 4) + 2048) << 2)));
  }
  let sums = f32x4.splat(0);
  for (let c: usize = 0; c < (<usize>CHOICES) << 2; c += 4) {
    const weights = load<usize>(CHOSEN + c);
    for (let k: usize = 0; k < (<usize>INPUTS) << 2; k += 16) {
      sums = f32x4.add(sums, f32x4.mul(v128.load(GUESSES + k), v128.load(weights + k)));
    }
  }
  const sum =
    f32x4.extract_lane(sums, 0) +
    f32x4.extract_lane(sums, 1) +
    (f32x4.extract_lane(sums, 2) + f32x4.extract_lane(sums, 3));
  const place = (min<f32>(11.9, max<f32>(-11.9, sum)) + REACH) * STEPS;
  const below = <i32>place;
  const p = squashed(below) + (squashed(below + 1) - squashed(below)) * (place - <f32>below);
  const result = bit(<u32>(p * 65534) + 1, expected);
  learn(result, p, node);
  return result;
}

// @ts-ignore: decorator
@inline function learn(result: u32, p: f32, node: u32): void {
  const step = f32x4.splat((<f32>result - p) * LEARNING_RATE);
  const target = f32x4.splat(result != 0 ? HALF - 1 : -HALF);
  for (let k: usize = 0; k < (<usize>INPUTS) << 2; k += 16) {
    const change = f32x4.mul(step, v128.load(GUESSES + k));
    for (let c: usize = 0; c < (<usize>CHOICES) << 2; c += 4) {
      const weights = load<usize>(CHOSEN + c) + k;
      v128.store(weights, f32x4.add(v128.load(weights), change));
    }
    const held = v128.load(HELD + k);
    const met = v128.and(held, i32x4.splat(15));
    const old = f32x4.convert_i32x4_s(i32x4.shr_s(held, 4));
    const rate = f32x4.add(f32x4.convert_i32x4_s(met), f32x4.splat(1.4));
    const changed = i32x4.trunc_sat_f32x4_s(f32x4.nearest(f32x4.add(old, f32x4.div(f32x4.sub(target, old), rate))));
    const often = i32x4.min_s(i32x4.add(met, i32x4.splat(1)), i32x4.splat(LONGEST_MEMORY));
    v128.store(HELD + k, v128.or(i32x4.shl(changed, 4), often));
  }
  for (let k: usize = 0; k < (<usize>CONTEXTS) << 2; k += 4) store<i16>(slotOf(k, node), load<i16>(HELD + k));
}

/** The slots of a byte's bits lie close together: `node` is a 1 and the bits before, or tells what was expected. */
// @ts-ignore: decorator
@inline function slotOf(k: usize, node: u32): usize {
  return load<usize>(CONTEXT_SLOTS + k) ^ (node << 1);
}
