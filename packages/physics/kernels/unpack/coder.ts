// An arithmetic code without carries, as in lpaq (M. Mahoney, 2007): the more likely a bit was held, the less of the code
// it takes. Of 64 bits rather than 32: where both ends differ in their first byte yet lie close together, few bits are left
// to tell probabilities by, which takes 0.5 % more code.
import { BYTES, PACKED } from './memory';

/** Alike at first: so the first bit fills the code. */
let low: u64 = 0;
let high: u64 = 0;
let code: u64 = 0;
let stream: usize = PACKED;
/** Packing: bits come from the bytes there are, and the code is written. */
let packing = false;
let source: u32 = 0;

export function beginPacking(): void {
  packing = true;
  // Unpacking fills the code before it needs it, packing empties it after: zeros come first.
  stream -= sizeof<u64>();
}

/** Enough of the code to tell the last bit, when zeros follow: how many bytes it has. */
export function endPacking(): i32 {
  for (; (low ^ high) >>> 56 == 0; low <<= 8, high <<= 8) store<u8>(stream++, high >>> 56);
  store<u8>(stream, high >>> 56);
  return <i32>(stream + 1 - PACKED);
}

/** Bytes that are not packed. */
export function skipBytes(count: u32): void {
  source += count << 3;
}

/**
 * The next bit, whose probability of being 1 is that many 65536ths, 1 to 65535. Packing asks whether the next byte is
 * the `expected` one, unless that is negative, or else for the bits of it.
 */
export function bit(probability: u32, expected: i32): u32 {
  while ((low ^ high) >>> 56 == 0) {
    if (packing) store<u8>(stream, high >>> 56);
    else code = (code << 8) | load<u8>(stream);
    stream++;
    low <<= 8;
    high = (high << 8) | 255;
  }
  const middle = low + ((high - low) >>> 16) * <u64>probability;
  let result = u32(code <= middle);
  if (packing) {
    const byte = <i32>load<u8>(BYTES + (source >>> 3));
    if (expected >= 0) {
      result = u32(byte == expected);
      source += result << 3;
    } else {
      result = (byte >>> (7 - (source & 7))) & 1;
      source++;
    }
  }
  if (result != 0) high = middle;
  else low = middle + 1;
  return result;
}
