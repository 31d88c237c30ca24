/** The builds of one kernel module, as base64. A build omitted from the bundle is an empty string. */
export interface EmbeddedModule {
  readonly f32: string;
  readonly f64: string;
}

/** Available in JavaScript engines since 2025, but missing in TypeScript's declarations. */
interface Base64Decoder {
  fromBase64?(text: string): Uint8Array<ArrayBuffer>;
}

/** Decodes a base64 text. */
export function decodeBase64(text: string): Uint8Array<ArrayBuffer> {
  return (Uint8Array as Base64Decoder).fromBase64?.(text) ?? bytesOf(atob(text));
}

/** One byte per character; all characters are below 256. */
function bytesOf(binary: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}
