/**
 * Text for two WebAssembly modules, the counterpart of `decodeModule` in the physics package.
 *
 * Both precisions come from one source and are nearly alike, but gzip, which packs what a site sends, looks back only
 * 32 KB and at whole bytes. Compressed together by LZMA they take 27 KB of a game where the same as hexadecimal text
 * took 37 KB; base 64 of it costs gzip nothing, since 64 signs that are all as likely take it 6 bits each.
 */
import lzma from 'lzma';

/** Bytes of an .lzma header: properties, size of the dictionary, size of the content. */
const HEADER = 13;

/** lc + 9 (lp + 5 pb) for lc = 3, lp = 0, pb = 2: what the decoder takes. */
const PROPERTIES = 93;

/**
 * @param {Uint8Array} first
 * @param {Uint8Array} second
 * @returns {string}
 */
export function encodeModules(first, second) {
  const file = Uint8Array.from(lzma.compress(Buffer.concat([first, second]), 9));
  if (file[0] !== PROPERTIES)
    throw new Error(`LZMA's properties are ${file[0]}, the decoder knows ${PROPERTIES} only.`);
  return Buffer.from(file.subarray(HEADER)).toString('base64').replaceAll('=', '');
}
