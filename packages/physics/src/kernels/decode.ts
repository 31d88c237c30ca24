import { SIGNS, UNPACKER } from './texts.gen';

/** One of two modules that were packed together, one after the other, and written in 64 signs. */
export interface EmbeddedModule {
  readonly text: string;
  /** Where its bytes begin and end among those of both. */
  readonly start: number;
  readonly end: number;
}

/** What `kernels/unpack/unpack.ts` exports. */
interface Unpacker {
  readonly memory: WebAssembly.Memory;
  packedAt(): number;
  bytesAt(): number;
  unpack(first: number, second: number): void;
}

let unpacker: WebAssembly.Module | undefined;

/** The bytes of an embedded WebAssembly module. */
export function decodeModule({ text, start, end }: EmbeddedModule): Uint8Array<ArrayBuffer> {
  unpacker ??= new WebAssembly.Module(readSigns(UNPACKER, 4, new Uint8Array(UNPACKER.length / 2), 0));
  const { memory, packedAt, bytesAt, unpack } = new WebAssembly.Instance(unpacker).exports as unknown as Unpacker;
  const bytes = new Uint8Array(memory.buffer);
  readSigns(text, 6, bytes, packedAt());
  const first = start === 0 ? end : start;
  unpack(first, end - first);
  return bytes.slice(bytesAt() + start, bytesAt() + end);
}

/** No `atob` and no `Buffer`, so it runs in Node, browsers, workers and worklets alike. */
function readSigns<Bytes extends Uint8Array>(text: string, width: number, bytes: Bytes, to: number): Bytes {
  const digits = new Uint8Array(128);
  for (let i = 0; i < SIGNS.length; i++) digits[SIGNS.charCodeAt(i)] = i;
  let held = 0;
  let bits = 0;
  for (let i = 0, at = to; i < text.length; i++) {
    held = (held << width) | digits[text.charCodeAt(i)];
    bits += width;
    if (bits < 8) continue;
    bits -= 8;
    bytes[at++] = held >> bits;
  }
  return bytes;
}
