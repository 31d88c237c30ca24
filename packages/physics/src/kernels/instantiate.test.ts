import { expect, test } from 'vitest';
import { KERNELS, type KernelExports } from './core.gen.ts';
import { decodeHex } from './decode.ts';
import { instantiate } from './instantiate.ts';
import { KERNELS as MATH, type KernelExports as MathKernels } from './math.gen.ts';

test('both builds export the same kernels under their own names', () => {
  const [f32, f64] = [KERNELS.f32, KERNELS.f64].map((text) => new WebAssembly.Module(decodeHex(text)));
  expect(WebAssembly.Module.exports(f32)).toEqual(WebAssembly.Module.exports(f64));
  const kernels = instantiate<KernelExports>(KERNELS, 'f64', new WebAssembly.Memory({ initial: 1 }));
  for (const kernel of Object.values(kernels)) expect(kernel).toBeTypeOf('function');
  expect(Object.keys(kernels)).toContain('zeroColumn');
});

test('elementary functions are the same for worlds of both precisions', () => {
  expect(MATH.f32).toBe(MATH.f64);
  const memory = new WebAssembly.Memory({ initial: 1 });
  expect(instantiate<MathKernels>(MATH, 'f32', memory).logarithm(Math.E)).toBe(1);
});

test.each([
  ['f32', 'f64'],
  ['f64', 'f32'],
] as const)(
  'a build for %s that the bundle leaves out is asked for in vain, and the error says why',
  (missing, kept) => {
    const memory = new WebAssembly.Memory({ initial: 1 });
    expect(() => instantiate({ ...KERNELS, [missing]: '' }, missing, memory)).toThrow(
      expect.objectContaining({
        code: 'E_RANGE',
        field: 'precision',
        value: missing,
        message: expect.stringContaining(`build without the condition principia-${kept}`),
      }),
    );
    expect(instantiate({ ...KERNELS, [missing]: '' }, kept, memory)).toBeDefined();
  },
);
