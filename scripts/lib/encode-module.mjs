/**
 * Text for two WebAssembly modules, the counterpart of `decodeModule` in the physics package.
 *
 * Both precisions come from one source and are nearly alike, but gzip, which packs what a site sends, looks back only
 * 32 KB and at whole bytes. `kernels/unpack` knows what WebAssembly looks like: what took 36 KB of a game as hexadecimal
 * text, and 24 KB by LZMA, takes it 16 KB. The first module is unpacked alone, the second needs the first.
 */
import { compileAlone } from './compile-kernels.mjs';

/** The memory of `kernels/unpack/memory.ts`: up to `PACKED`, and what may follow. */
const PAGES = 72;
/**
 * What bytes are written in: 64 signs that are all as likely take gzip 6 bits each, so it costs nothing. They are those
 * that are most frequent in code, because a block of gzip has one table for its text and its code: 0.3 KB.
 */
export const SIGNS = 'abcdefghijklmnopqrstuvwxyz0123456789.,:;=+-*/()[]{}!&|?ABCDEFGHI';

/** The most that one module may have there. */
const MOST_BYTES = 0x10000;

/** @param {string} folder of the kernels */
export async function compilePacker(folder) {
  const [pack, unpack] = await Promise.all([
    compileAlone(folder, 'unpack/pack.ts', PAGES),
    compileAlone(folder, 'unpack/unpack.ts', PAGES),
  ]);
  return { pack, unpack };
}

/**
 * @param {Uint8Array} packer the module of `kernels/unpack/pack.ts`
 * @param {Uint8Array} first
 * @param {Uint8Array} second
 * @returns {string}
 */
export function encodeModules(packer, first, second) {
  if (Math.max(first.length, second.length) > MOST_BYTES)
    throw new Error(
      `A kernel module has ${Math.max(first.length, second.length)} bytes, the packer takes ${MOST_BYTES}.`,
    );
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(Uint8Array.from(packer)));
  const { memory, packedAt, bytesAt, pack } = /** @type {any} */ (exports);
  const both = Buffer.concat([first, second]);
  const bytes = Buffer.from(memory.buffer, bytesAt(), both.length);
  bytes.set(both);
  const length = pack(first.length, second.length);
  // Sizes of bodies are written anew.
  if (!bytes.equals(both))
    throw new Error('A kernel module has bodies whose sizes are not as `padBodySizes` makes them.');
  return inSigns(new Uint8Array(memory.buffer, packedAt(), length), 6);
}

/**
 * @param {Uint8Array} bytes
 * @param {number} width bits a sign, 6 at most; gzip packs 4 better where bytes repeat
 */
export function inSigns(bytes, width) {
  let text = '';
  let held = 0;
  let bits = 0;
  // A byte of zeros, so that the last bits are written too; what is too many is cut off.
  for (const byte of [...bytes, 0]) {
    held = ((held << 8) | byte) & 0xffff;
    for (bits += 8; bits >= width; bits -= width) text += SIGNS[(held >> (bits - width)) & ((1 << width) - 1)];
  }
  return text.slice(0, Math.ceil((bytes.length * 8) / width));
}
