/** One of two modules whose hexadecimal text is dealt out in turns: `turn` 0 owns the even chunks, 1 the odd ones. */
export interface EmbeddedModule {
  readonly chunks: readonly string[];
  readonly turn: 0 | 1;
}

/**
 * The bytes of an embedded WebAssembly module. Hexadecimal because it keeps bytes aligned, so that gzip and brotli
 * find the repetitions in the code; no `atob` and no `Buffer`, so it runs in Node, browsers and workers alike.
 */
export function decodeModule({ chunks, turn }: EmbeddedModule): Uint8Array<ArrayBuffer> {
  const text = chunks.filter((_, index) => index % 2 === turn).join('');
  const bytes = new Uint8Array(text.length / 2);
  for (let i = 0; i < bytes.length; i++) {
    bytes[i] = digit(text.charCodeAt(2 * i)) * 16 + digit(text.charCodeAt(2 * i + 1));
  }
  return bytes;
}

/** '0'…'9' are 48…57 and 'a'…'f' are 97…102. */
function digit(code: number): number {
  return code < 58 ? code - 48 : code - 87;
}
