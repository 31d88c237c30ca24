import { expect, test } from 'vitest';
import { kernelFolder } from '../../../../scripts/build-kernels.mjs';
import { compilePacker, encodeModules } from '../../../../scripts/lib/encode-module.mjs';
import { decodeModule } from './decode.ts';
import { KERNELS_F32, KERNELS_F64 } from './modules.gen.ts';

const packer = compilePacker(kernelFolder);
const noise = (length: number) => Uint8Array.from({ length }, (_, i) => Math.imul(i * i + 12345, 0x9e3779b1) >>> 24);
const wave = (length: number) => Uint8Array.from({ length }, (_, i) => (i * i) >> 7);
const flat = (length: number) => new Uint8Array(length).fill(200);

test.each([
  ['noise', noise, [0, 1, 5, 5000]],
  ['what is like itself', wave, [1, 2, 9000]],
  ['one byte over and over', flat, [1, 18, 3000]],
])('%s survives the round trip', { timeout: 60_000 }, async (_, make, lengths) => {
  const { pack } = await packer;
  const longest = make(lengths[lengths.length - 1]);
  for (const first of lengths.map(make)) {
    for (const second of [longest, first]) {
      const text = encodeModules(pack, first, second);
      const middle = first.length;
      expect(decodeModule({ text, start: 0, end: middle })).toEqual(first);
      expect(decodeModule({ text, start: middle, end: middle + second.length })).toEqual(second);
    }
  }
});

test('both embedded modules are valid and export the same kernels', () => {
  const [f32, f64] = [KERNELS_F32, KERNELS_F64].map((kernels) => new WebAssembly.Module(decodeModule(kernels)));
  expect(WebAssembly.Module.exports(f32).length).toBeGreaterThan(0);
  expect(WebAssembly.Module.exports(f32)).toEqual(WebAssembly.Module.exports(f64));
});
