import { compileBytes } from './compile-bytes.ts';
import { SIGNS, UNPACKER } from './texts.gen.ts';

/** Two builds of one module, packed together and written in 64 signs. */
export interface EmbeddedModule {
  readonly text: string;
  /** What the functions that both export are called, with dots between; the modules have other names for them. */
  readonly names: string;
  /** How many bytes the build has that is unpacked alone, as worlds are f64 unless one asks for f32. */
  readonly f64: number;
  /** How many bytes the build has that is unpacked after it. */
  readonly f32: number;
  /** What was compiled of them in this process. */
  readonly compiled: { f32?: WebAssembly.Module; f64?: WebAssembly.Module };
}

/** What `kernels/unpack/unpack.ts` exports. */
interface Unpacker {
  readonly memory: WebAssembly.Memory;
  packedAt(): number;
  bytesAt(): number;
  unpack(first: number, second: number): void;
}

let unpacker: WebAssembly.Module | undefined;

/** The bytes of one build of an embedded WebAssembly module. */
export function decodeModule({ text, f64, f32 }: EmbeddedModule, precision: 'f32' | 'f64'): Uint8Array<ArrayBuffer> {
  unpacker ??= compileBytes(readSigns(UNPACKER, 4, new Uint8Array(UNPACKER.length / 2), 0));
  const { memory, packedAt, bytesAt, unpack } = new WebAssembly.Instance(unpacker).exports as unknown as Unpacker;
  const bytes = new Uint8Array(memory.buffer);
  readSigns(text, 6, bytes, packedAt());
  const second = precision === 'f32' ? f32 : 0;
  unpack(f64, second);
  const from = bytesAt();
  return second > 0 ? bytes.slice(from + f64, from + f64 + second) : bytes.slice(from, from + f64);
}

/** No `atob` and no `Buffer`, so it runs in Node, browsers, workers and worklets alike. */
function readSigns<Bytes extends Uint8Array>(text: string, width: number, bytes: Bytes, to: number): Bytes {
  const digits = new Uint8Array(128);
  for (let i = 0; i < SIGNS.length; i++) digits[SIGNS.charCodeAt(i)] = i;
  let held = 0;
  let bits = 0;
  for (let i = 0, at = to; i < text.length; i++) {
    held = (held << width) | digits[text.charCodeAt(i)];
    bits += width;
    if (bits < 8) continue;
    bits -= 8;
    bytes[at++] = held >> bits;
  }
  return bytes;
}
