/**
 * The bytes of an embedded WebAssembly module. Hexadecimal because it keeps bytes aligned, so that gzip and brotli
 * find the repetitions in the code; no `atob` and no `Buffer`, so it runs in Node, browsers and workers alike.
 */
export function decodeModule(text: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(text.length / 2);
  for (let i = 0; i < bytes.length; i++) bytes[i] = Number.parseInt(text.substring(2 * i, 2 * i + 2), 16);
  return bytes;
}
