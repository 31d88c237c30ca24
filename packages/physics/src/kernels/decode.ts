import { decodeLzma } from './lzma';

/** One of two modules that were compressed together, one after the other, and written in base 64. */
export interface EmbeddedModule {
  readonly text: string;
  /** Where its bytes begin and end among those of both. */
  readonly start: number;
  readonly end: number;
}

/** The bytes of an embedded WebAssembly module. */
export function decodeModule({ text, start, end }: EmbeddedModule): Uint8Array<ArrayBuffer> {
  return decodeLzma(decodeBase64(text), end).slice(start);
}

/** No `atob` and no `Buffer`, so it runs in Node, browsers, workers and worklets alike; text without padding. */
function decodeBase64(text: string): Uint8Array {
  const bytes = new Uint8Array((text.length * 6) >> 3);
  let bits = 0;
  for (let i = 0, at = 0; i < text.length; i++) {
    bits = (bits << 6) | digit(text.charCodeAt(i));
    if (i % 4 > 0) bytes[at++] = (bits >> (6 - 2 * (i % 4))) & 255;
  }
  return bytes;
}

/** 'A'…'Z', 'a'…'z', '0'…'9', '+' and '/' are 65…90, 97…122, 48…57, 43 and 47. */
function digit(code: number): number {
  if (code >= 97) return code - 71;
  if (code >= 65) return code - 65;
  if (code >= 48) return code + 4;
  return code === 43 ? 62 : 63;
}
