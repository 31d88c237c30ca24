/**
 * Text for a WebAssembly module, the counterpart of `decodeModule` in the physics package. Hexadecimal keeps bytes
 * aligned, so gzip and brotli still find the repetitions that base64 hides.
 * @param {Uint8Array} wasm
 */
export function encodeModule(wasm) {
  return Buffer.from(wasm).toString('hex');
}
