// Packs two builds of a module, which stand at `BYTES`, for the scripts; see `reader.ts`.
import { beginPacking, endPacking } from './coder';
import { readModules } from './reader';

export { bytesAt, packedAt } from './unpack';

/** Two modules of so many bytes; how many bytes they are packed in. Packs once an instance. */
export function pack(first: i32, second: i32): i32 {
  beginPacking();
  readModules(first, second);
  return endPacking();
}
