import { describe, expect, test } from 'vitest';
import { instantiate } from '../kernels/instantiate.ts';
import { KERNELS, type KernelExports } from '../kernels/math.gen.ts';
import { createRandom } from './random.ts';

const N = 200_000;

/** Mean and variance of N draws. */
function moments(draw: () => number): { mean: number; variance: number } {
  let sum = 0;
  let squares = 0;
  for (let i = 0; i < N; i++) {
    const x = draw();
    sum += x;
    squares += x * x;
  }
  return { mean: sum / N, variance: squares / N - (sum / N) ** 2 };
}

describe('seeded random numbers', () => {
  test('begin differently for every seed, and spread over the whole range', () => {
    const firsts = Array.from({ length: 1000 }, (_, seed) => createRandom(seed).uniform());
    expect(new Set(firsts).size).toBe(1000);
    const mean = firsts.reduce((sum, value) => sum + value, 0) / 1000;
    // A uniform number has variance 1/12: the bound is three standard deviations of the mean of a thousand.
    expect(Math.abs(mean - 0.5)).toBeLessThan(3 * Math.sqrt(1 / 12 / 1000));
  });

  test('follow the reference xoshiro128** from state 1, 2, 3, 4', () => {
    const random = createRandom(0);
    random.state.set([1, 2, 3, 4]);
    expect(Array.from({ length: 6 }, () => random.word())).toEqual([
      11520, 0, 5927040, 70819200, 2031721883, 1637235492,
    ]);
  });

  test('are the same for the same seed and differ between seeds and streams', () => {
    const first = (seed: number, stream = 0) => {
      const random = createRandom(seed, stream);
      return Array.from({ length: 4 }, () => random.word()).join();
    };
    expect(first(1)).toBe(first(1));
    const all = new Set<string>();
    for (let seed = 0; seed < 100; seed++) for (let stream = 0; stream < 20; stream++) all.add(first(seed, stream));
    for (const seed of [2 ** 32, 2 ** 32 + 1, 2 ** 53 - 1]) all.add(first(seed));
    expect(all.size).toBe(2003);
  });

  test('a split stream is uncorrelated with its parent', () => {
    const parent = createRandom(5);
    const child = parent.split();
    let product = 0;
    for (let i = 0; i < N; i++) product += (parent.uniform() - 0.5) * (child.uniform() - 0.5);
    // The product of two uniform deviations has standard deviation 1/12.
    expect(Math.abs(product / N)).toBeLessThan(3 / 12 / Math.sqrt(N));
  });

  test('uniform has mean 1/2, variance 1/12 and even bins', () => {
    const random = createRandom(2);
    const { mean, variance } = moments(() => random.uniform());
    expect(Math.abs(mean - 1 / 2)).toBeLessThan(3 * Math.sqrt(1 / 12 / N));
    expect(Math.abs(variance - 1 / 12)).toBeLessThan(3 * Math.sqrt(1 / 180 / N));
    expect(chiSquared(256, () => Math.floor(random.uniform() * 256))).toBeLessThan(3);
  });

  test('integers are even, ends included', () => {
    const random = createRandom(3);
    expect(chiSquared(6, () => random.integer(1, 6) - 1)).toBeLessThan(3);
    expect(() => random.integer(2, 1)).toThrow('E_RANGE');
    expect(() => random.integer(0.5, 1)).toThrow('E_RANGE');
    expect(random.integer(0, 2 ** 32 - 1)).toBeGreaterThan(-1);
  });

  test('signs are fair', () => {
    const random = createRandom(4);
    expect(Math.abs(moments(() => random.sign()).mean)).toBeLessThan(3 / Math.sqrt(N));
  });

  test('gaussian has mean 0, variance 1 and no skew', () => {
    const random = createRandom(8);
    let cubes = 0;
    const { mean, variance } = moments(() => {
      const x = random.gaussian();
      cubes += x ** 3;
      return x;
    });
    expect(Math.abs(mean)).toBeLessThan(3 / Math.sqrt(N));
    expect(Math.abs(variance - 1)).toBeLessThan(3 * Math.sqrt(2 / N));
    expect(Math.abs(cubes / N)).toBeLessThan(3 * Math.sqrt(15 / N));
    expect(createRandom(8).gaussian(10, 2)).toBe(10 + 2 * createRandom(8).gaussian());
  });

  test('points of circle and sphere have their radius and mean zero', () => {
    const random = createRandom(9);
    for (const [draw, axes] of [
      [() => random.onCircle(2), ['x', 'y']],
      [() => random.onSphere(2), ['x', 'y', 'z']],
    ] as const) {
      for (const axis of axes) {
        const { mean, variance } = moments(() => draw()[axis]);
        expect(Math.abs(mean)).toBeLessThan((3 * 2) / Math.sqrt(axes.length * N));
        expect(Math.abs(variance * axes.length - 4)).toBeLessThan(0.05);
      }
      const { x, y, z } = draw();
      expect(Math.hypot(x, y, z)).toBeCloseTo(2, 12);
    }
  });

  test('the kernels draw the same numbers from the same words', () => {
    for (const precision of ['f32', 'f64'] as const) {
      const memory = new WebAssembly.Memory({ initial: 1 });
      const kernels = instantiate<KernelExports>(KERNELS, precision, memory);
      const random = createRandom(11);
      const words = new Uint32Array(memory.buffer, 8192, 4);
      words.set(random.state);
      for (let i = 0; i < 1000; i++) {
        expect(kernels.randomWord(8192) >>> 0).toBe(random.word());
        expect(kernels.randomUnit(8192)).toBe(random.uniform());
        expect(kernels.randomNormal(8192)).toBe(random.gaussian());
      }
      expect([...words]).toEqual([...random.state]);
    }
  });
});

/** Number of standard deviations by which the χ² of `bins` bins exceeds its mean. */
function chiSquared(bins: number, draw: () => number): number {
  const counts = new Float64Array(bins);
  for (let i = 0; i < N; i++) {
    const bin = draw();
    counts[bin] = (counts[bin] as number) + 1;
  }
  const expected = N / bins;
  const chi = counts.reduce((sum, count) => sum + (count - expected) ** 2 / expected, 0);
  return (chi - (bins - 1)) / Math.sqrt(2 * (bins - 1));
}
