import { expect, test } from 'vitest';
import { kernelFolder } from '../../../../scripts/build-kernels.mjs';
import { padBodySizes } from '../../../../scripts/lib/body-sizes.mjs';
import { compilePacker, encodeModules } from '../../../../scripts/lib/encode-module.mjs';
import { decodeModule, type EmbeddedModule } from './decode.ts';
import { instantiate } from './instantiate.ts';
import { KERNELS, type KernelExports } from './modules.gen.ts';

const packer = compilePacker(kernelFolder);
const noise = (length: number) => Uint8Array.from({ length }, (_, i) => Math.imul(i * i + 12345, 0x9e3779b1) >>> 24);
const wave = (length: number) => Uint8Array.from({ length }, (_, i) => (i * i) >> 7);
const flat = (length: number) => new Uint8Array(length).fill(200);

/** A module with these bytes in a section of its own, whose size takes two bytes. */
const moduleOf = (bytes: Uint8Array) =>
  Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 0, (bytes.length & 127) | 128, bytes.length >> 7, ...bytes);

const embed = (text: string, first: Uint8Array, second: Uint8Array): EmbeddedModule => {
  return { text, names: '', f64: first.length, f32: second.length, compiled: {} };
};

test.each([
  ['noise', noise, [0, 1, 5, 5000]],
  ['what is like itself', wave, [1, 2, 9000]],
  ['one byte over and over', flat, [1, 18, 3000]],
])('%s survives the round trip', { timeout: 60_000 }, async (_, make, lengths) => {
  const { pack } = await packer;
  const modules = lengths.map((length) => moduleOf(make(length)));
  const longest = modules[modules.length - 1];
  for (const first of modules) {
    for (const second of [longest, first]) {
      const embedded = embed(encodeModules(pack, first, second), first, second);
      expect(decodeModule(embedded, 'f64')).toEqual(first);
      expect(decodeModule(embedded, 'f32')).toEqual(second);
    }
  }
});

test('a module whose bodies have sizes of other lengths is refused', async () => {
  const { pack } = await packer;
  const empty = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 0x60, 0, 0, 3, 2, 1, 0];
  const short = Uint8Array.of(...empty, 10, 4, 1, 2, 0, 0x0b);
  expect(() => encodeModules(pack, short, short)).toThrow(/bodies whose sizes/);
  const padded = Uint8Array.from(padBodySizes(short));
  expect(WebAssembly.validate(padded)).toBe(true);
  const text = encodeModules(pack, padded, padded);
  expect(decodeModule(embed(text, padded, padded), 'f64')).toEqual(padded);
});

test('both embedded modules are valid and export the same kernels, as many as have names', () => {
  const [f32, f64] = (['f32', 'f64'] as const).map((real) => new WebAssembly.Module(decodeModule(KERNELS, real)));
  expect(WebAssembly.Module.exports(f32)).toEqual(WebAssembly.Module.exports(f64));
  expect(WebAssembly.Module.exports(f32)).toHaveLength(KERNELS.names.split('.').length);
});

test('the kernels have their names back', () => {
  const memory = new WebAssembly.Memory({ initial: 1 });
  const kernels = instantiate<KernelExports>(KERNELS, 'f64', memory);
  expect(Object.keys(kernels)).toEqual(KERNELS.names.split('.'));
  for (const kernel of Object.values(kernels)) expect(kernel).toBeTypeOf('function');
  expect(kernels.logarithm(Math.E)).toBe(1);
});
