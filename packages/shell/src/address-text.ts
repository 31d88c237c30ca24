/** Bytes and texts in the letters of addresses: URL-safe base64 without padding. */

export function textOfBytes(bytes: Uint8Array): string {
  const binary = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/**
 * The bytes of a text that `textOfBytes` made.
 * @throws Error where the text is no base64
 */
export function bytesOfText(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
}

/** Compresses a text. */
export async function packText(text: string): Promise<string> {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return textOfBytes(new Uint8Array(await new Response(stream).arrayBuffer()));
}

/** The text that `packText` compressed. @throws Error where it is cut or none */
export async function unpackText(packed: string): Promise<string> {
  const stream = new Blob([bytesOfText(packed)]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Response(stream).text();
}
