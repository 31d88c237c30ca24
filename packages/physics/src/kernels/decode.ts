import { UNPACKER } from './texts.gen';

/** One of two modules that were packed together, one after the other, and written in base 64. */
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
  unpacker ??= new WebAssembly.Module(decodeHexadecimal(UNPACKER));
  const { memory, packedAt, bytesAt, unpack } = new WebAssembly.Instance(unpacker).exports as unknown as Unpacker;
  const bytes = new Uint8Array(memory.buffer);
  decodeBase64(text, bytes, packedAt());
  const first = start === 0 ? end : start;
  unpack(first, end - first);
  return bytes.slice(bytesAt() + start, bytesAt() + end);
}

function decodeHexadecimal(text: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from({ length: text.length / 2 }, (_, i) => Number.parseInt(text.slice(2 * i, 2 * i + 2), 16));
}

/** No `atob` and no `Buffer`, so it runs in Node, browsers, workers and worklets alike; text without padding. */
function decodeBase64(text: string, bytes: Uint8Array, to: number): void {
  let bits = 0;
  for (let i = 0, at = to; i < text.length; i++) {
    bits = (bits << 6) | digit(text.charCodeAt(i));
    if (i % 4 > 0) bytes[at++] = (bits >> (6 - 2 * (i % 4))) & 255;
  }
}

/** 'A'…'Z', 'a'…'z', '0'…'9', '+' and '/' are 65…90, 97…122, 48…57, 43 and 47. */
function digit(code: number): number {
  if (code >= 97) return code - 71;
  if (code >= 65) return code - 65;
  if (code >= 48) return code + 4;
  return code === 43 ? 62 : 63;
}
