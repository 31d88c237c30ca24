// Unpacks what `pack.ts` packed: the code at `PACKED`, whose bytes are the result.
import { BYTES, PACKED } from './memory';
import { readModules } from './reader';

/** Where the code goes, and where the bytes come. */
export function packedAt(): usize {
  return PACKED;
}

export function bytesAt(): usize {
  return BYTES;
}

/** Two modules of so many bytes; unpacks once an instance. */
export function unpack(first: i32, second: i32): void {
  readModules(first, second);
}
