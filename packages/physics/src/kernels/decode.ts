/** The builds of one kernel module, as base64. A build that the bundle leaves out is an empty text. */
export interface EmbeddedModule {
  readonly f32: string;
  readonly f64: string;
}

/** What JavaScript engines have since 2025, and TypeScript's own declarations lack. */
interface Base64Decoder {
  fromBase64?(text: string): Uint8Array<ArrayBuffer>;
}

/** The bytes that a base64 text stands for. */
export function decodeBase64(text: string): Uint8Array<ArrayBuffer> {
  return (Uint8Array as Base64Decoder).fromBase64?.(text) ?? bytesOf(atob(text));
}

/** One byte a character, each of which is below 256. */
function bytesOf(binary: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}
