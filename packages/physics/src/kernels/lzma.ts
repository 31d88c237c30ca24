// Decompresses LZMA, as the raw stream after the 13 bytes of an .lzma header, with lc = 3, lp = 0, pb = 2.
//
// Of two builds of the same kernels the second is nearly a copy of the first, 30 KB back, and code has few whole bytes
// in common but many likely bits: LZMA takes a quarter less than deflate, for 1.2 KB of decoder and some milliseconds.
// Source: Igor Pavlov, LZMA specification (2015), public domain; names are those of its decoder.

/** Where each set of probabilities starts in the one array that holds all. */
const IS_MATCH = 0;
const IS_REP = 192;
const IS_REP_G0 = 204;
const IS_REP_G1 = 216;
const IS_REP_G2 = 228;
const IS_REP0_LONG = 240;
const POS_SLOT = 432;
const POS_SPECIAL = 688;
const ALIGN = 803;
const LENGTH = 819;
const REP_LENGTH = 1333;
const LITERAL = 1847;
const PROBABILITIES = LITERAL + (0x300 << 3);

class RangeDecoder {
  readonly #input: Uint8Array;
  readonly #probabilities = new Uint16Array(PROBABILITIES).fill(1024);
  #at = 5;
  #range = 0xffffffff;
  #code: number;

  constructor(input: Uint8Array) {
    this.#input = input;
    this.#code = new DataView(input.buffer, input.byteOffset + 1).getUint32(0);
  }

  /** One bit, by its adaptive probability. */
  bit(index: number): 0 | 1 {
    const p = this.#probabilities[index];
    const bound = (this.#range >>> 11) * p;
    const bit = this.#code < bound ? 0 : 1;
    if (bit === 0) {
      this.#range = bound;
      this.#probabilities[index] = p + ((2048 - p) >>> 5);
    } else {
      this.#range -= bound;
      this.#code -= bound;
      this.#probabilities[index] = p - (p >>> 5);
    }
    this.#normalise();
    return bit;
  }

  /** Bits that are as likely 0 as 1. */
  direct(count: number): number {
    let result = 0;
    for (let i = 0; i < count; i++) {
      this.#range >>>= 1;
      const bit = this.#code < this.#range ? 0 : 1;
      if (bit === 1) this.#code -= this.#range;
      this.#normalise();
      result = 2 * result + bit;
    }
    return result;
  }

  /** `count` bits, the highest first. */
  tree(base: number, count: number): number {
    let symbol = 1;
    for (let i = 0; i < count; i++) symbol = 2 * symbol + this.bit(base + symbol);
    return symbol - (1 << count);
  }

  /** `count` bits, the lowest first. */
  reverseTree(base: number, count: number): number {
    let symbol = 1;
    let result = 0;
    for (let i = 0; i < count; i++) {
      const bit = this.bit(base + symbol);
      symbol = 2 * symbol + bit;
      result += bit << i;
    }
    return result;
  }

  #normalise(): void {
    if (this.#range >= 0x1000000) return;
    this.#range = (this.#range << 8) >>> 0;
    this.#code = ((this.#code << 8) | (this.#input[this.#at++] ?? 0)) >>> 0;
  }
}

/** The first `size` bytes of what was compressed. */
export function decodeLzma(input: Uint8Array, size: number): Uint8Array<ArrayBuffer> {
  const decoder = new RangeDecoder(input);
  const output = new Uint8Array(size);
  const distances = [1, 1, 1, 1];
  let state = 0;
  for (let at = 0; at < size; ) {
    const place = at & 3;
    if (decoder.bit(IS_MATCH + state * 16 + place) === 0) {
      output[at] = literal(decoder, output, at, state < 7 ? 0 : distances[0]);
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      at++;
      continue;
    }
    const repeats = decoder.bit(IS_REP + state) === 1;
    let count = 1;
    if (repeats && isShort(decoder, distances, state, place)) {
      state = state < 7 ? 9 : 11;
    } else {
      count = length(decoder, repeats ? REP_LENGTH : LENGTH, place);
      if (!repeats) distances.unshift(distance(decoder, count - 2));
      state = (state < 7 ? 7 : 10) + (repeats ? 1 : 0);
    }
    distances.length = 4;
    for (const end = Math.min(at + count, size); at < end; at++) output[at] = output[at - distances[0]];
  }
  return output;
}

/** After a match, the byte at its distance tells what the literal is not. */
function literal(decoder: RangeDecoder, output: Uint8Array, at: number, matched: number): number {
  const base = LITERAL + 0x300 * ((output[at - 1] ?? 0) >> 5);
  let symbol = 1;
  for (let match = output[at - matched], shift = 7; matched > 0 && shift >= 0; shift--) {
    const expected = (match >> shift) & 1;
    const bit = decoder.bit(base + ((1 + expected) << 8) + symbol);
    symbol = 2 * symbol + bit;
    if (bit !== expected) break;
  }
  while (symbol < 0x100) symbol = 2 * symbol + decoder.bit(base + symbol);
  return symbol - 0x100;
}

/** Puts the distance that is used again in front; whether it is used for one byte only. */
function isShort(decoder: RangeDecoder, distances: number[], state: number, place: number): boolean {
  if (decoder.bit(IS_REP_G0 + state) === 0) return decoder.bit(IS_REP0_LONG + state * 16 + place) === 0;
  const which = decoder.bit(IS_REP_G1 + state) === 0 ? 1 : 2 + decoder.bit(IS_REP_G2 + state);
  distances.unshift(...distances.splice(which, 1));
  return false;
}

function length(decoder: RangeDecoder, base: number, place: number): number {
  if (decoder.bit(base) === 0) return 2 + decoder.tree(base + 2 + place * 8, 3);
  if (decoder.bit(base + 1) === 0) return 10 + decoder.tree(base + 130 + place * 8, 3);
  return 18 + decoder.tree(base + 258, 8);
}

function distance(decoder: RangeDecoder, longer: number): number {
  const slot = decoder.tree(POS_SLOT + Math.min(longer, 3) * 64, 6);
  if (slot < 4) return slot + 1;
  const count = (slot >> 1) - 1;
  const high = (2 | (slot & 1)) << count;
  if (slot < 14) return high + decoder.reverseTree(POS_SPECIAL + high - slot, count) + 1;
  return high + decoder.direct(count - 4) * 16 + decoder.reverseTree(ALIGN, 4) + 1;
}
