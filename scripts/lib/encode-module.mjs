/**
 * Text for two WebAssembly modules, the counterpart of `decodeModule` in the physics package.
 *
 * Both precisions come from one source and are nearly alike, but gzip, which packs what a site sends, looks back only
 * 32 KB and at whole bytes. `kernels/unpack` knows what WebAssembly looks like: what took 37 KB of a game as hexadecimal
 * text, and 25 KB by LZMA, takes it 16 KB. The first module is unpacked alone, the second needs the first. Base 64 of it
 * costs gzip nothing, since 64 signs that are all as likely take it 6 bits each.
 */
import { compileAlone } from './compile-kernels.mjs';

/** The memory of `kernels/unpack/memory.ts`: up to `PACKED`, and what may follow. */
const PAGES = 72;
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
  return Buffer.from(memory.buffer, packedAt(), length).toString('base64').replaceAll('=', '');
}
