// An arithmetic code of 32 bits without carries, as in lpaq (M. Mahoney, 2007): the more likely a bit was held, the less
// of the code it takes.
import { BYTES, PACKED } from './memory';

let low: u32 = 0;
let high: u32 = 0xffffffff;
let code: u32 = 0;
let stream: usize = PACKED;
/** Packing: bits come from the bytes there are, and the code is written. */
let packing = false;
let source: u32 = 0;

export function beginUnpacking(): void {
  code = bswap(load<u32>(stream));
  stream += 4;
}

export function beginPacking(): void {
  packing = true;
}

/** Enough of the code to tell the last bit: how many bytes it has. */
export function endPacking(): i32 {
  store<u32>(stream, bswap(high));
  return <i32>(stream + 4 - PACKED);
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
  const middle = low + ((high - low) >>> 16) * probability;
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
  while ((low ^ high) >>> 24 == 0) {
    if (packing) store<u8>(stream, high >>> 24);
    else code = (code << 8) | load<u8>(stream);
    stream++;
    low <<= 8;
    high = (high << 8) | 255;
  }
  return result;
}
