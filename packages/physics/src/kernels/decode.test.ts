import { expect, test } from 'vitest';
import { encodeModules } from '../../../../scripts/lib/encode-module.mjs';
import { decodeModule } from './decode.ts';
import { KERNELS_F32, KERNELS_F64 } from './modules.gen.ts';

const bytes = (length: number, step: number) => Uint8Array.from({ length }, (_, i) => (i * step) & 255);

test.each([
  [0, 0],
  [1, 5000],
  [4096, 4097],
  [9000, 3],
])('modules of %i and %i bytes survive the round trip', (a, b) => {
  const [first, second] = [bytes(a, 7), bytes(b, 11)];
  const chunks = encodeModules(first, second);
  expect(decodeModule({ chunks, turn: 0 })).toEqual(first);
  expect(decodeModule({ chunks, turn: 1 })).toEqual(second);
});

test('both embedded modules are valid and export the same kernels', () => {
  const [f32, f64] = [KERNELS_F32, KERNELS_F64].map((kernels) => new WebAssembly.Module(decodeModule(kernels)));
  expect(WebAssembly.Module.exports(f32).length).toBeGreaterThan(0);
  expect(WebAssembly.Module.exports(f32)).toEqual(WebAssembly.Module.exports(f64));
});
