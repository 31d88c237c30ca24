/** The builds of one kernel module, in hexadecimal digits. A build omitted from the bundle is an empty string. */
export interface EmbeddedModule {
  readonly f32: string;
  readonly f64: string;
}

/** Available in JavaScript engines since 2025, but missing in TypeScript's declarations. */
interface HexDecoder {
  fromHex?(text: string): Uint8Array<ArrayBuffer>;
}

/** Decodes a text of two lower-case hexadecimal digits per byte. */
export function decodeHex(text: string): Uint8Array<ArrayBuffer> {
  return (Uint8Array as HexDecoder).fromHex?.(text) ?? bytesOf(text);
}

function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(text.length / 2);
  for (let i = 0; i < bytes.length; i++) {
    bytes[i] = (digitOf(text.charCodeAt(2 * i)) << 4) | digitOf(text.charCodeAt(2 * i + 1));
  }
  return bytes;
}

/** Of the code of a digit: 0 to 9 are 48 to 57, a to f are 97 to 102. */
function digitOf(code: number): number {
  return code < 58 ? code - 48 : code - 87;
}
