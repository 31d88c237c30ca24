import { describe, expect, test } from 'vitest';
import { atan2, cos, exp, log, pow, sin } from './elementary.ts';
import { createRandom } from './random.ts';

/** Distance of two f64 in units in the last place of the second; 0 if they are equal, NaN and infinities included. */
function ulps(value: number, expected: number): number {
  if (Object.is(value, expected)) return 0;
  const bits = new BigInt64Array(new Float64Array([value, expected]).buffer);
  return Number((bits[0] as bigint) - (bits[1] as bigint));
}

/** The largest distance of many random arguments. */
function worst(count: number, draw: (r: ReturnType<typeof createRandom>) => readonly [number, number]): number {
  const random = createRandom(7);
  let maxUlps = 0;
  for (let i = 0; i < count; i++) {
    const [value, expected] = draw(random);
    maxUlps = Math.max(maxUlps, Math.abs(ulps(value, expected)));
  }
  return maxUlps;
}

const SPECIAL = [0, -0, 1, -1, 0.5, -0.5, 2, -2, 3, -3, 1e300, -1e300, 1e-300, 5e-324, Infinity, -Infinity, Number.NaN];

describe('elementary functions against the engine’s', () => {
  test('sine and cosine, small angles and large', () => {
    for (const size of [1, 100, 1e5, 1e9, 1e15, 1e300]) {
      const maxUlps = size <= 1e5 ? 1 : 2;
      expect(
        worst(20_000, (r) => at(r.uniform(-size, size), sin, Math.sin)),
        `sin ${size}`,
      ).toBeLessThanOrEqual(maxUlps);
      expect(
        worst(20_000, (r) => at(r.uniform(-size, size), cos, Math.cos)),
        `cos ${size}`,
      ).toBeLessThanOrEqual(maxUlps);
    }
  });

  test('arc tangent in all quadrants', () => {
    const draw = (r: ReturnType<typeof createRandom>) => {
      const [y, x] = [r.uniform(-1, 1), r.uniform(-1, 1)];
      return [atan2(y, x), Math.atan2(y, x)] as const;
    };
    expect(worst(50_000, draw)).toBeLessThanOrEqual(1);
  });

  test('exponential and logarithm over their whole range', () => {
    expect(worst(50_000, (r) => at(r.uniform(-708, 709), exp, Math.exp))).toBeLessThanOrEqual(1);
    expect(worst(50_000, (r) => at(r.uniform(-1, 1), exp, Math.exp))).toBeLessThanOrEqual(1);
    expect(worst(50_000, (r) => at(Math.exp(r.uniform(-740, 709)), log, Math.log))).toBeLessThanOrEqual(1);
    expect(worst(50_000, (r) => at(r.uniform(0.9, 1.1), log, Math.log))).toBeLessThanOrEqual(1);
  });

  test('powers over their whole range', () => {
    const draw = (r: ReturnType<typeof createRandom>) => {
      const x = Math.exp(r.uniform(-20, 20));
      const y = r.uniform(-35, 35);
      return [pow(x, y), x ** y] as const;
    };
    expect(worst(50_000, draw)).toBeLessThanOrEqual(1);
    expect(pow(10, 22)).toBe(1e22);
    expect(pow(2, -1074)).toBe(5e-324);
  });

  test('special values are those of ECMAScript', () => {
    for (const x of SPECIAL) {
      for (const f of ['sin', 'cos', 'exp', 'log'] as const) {
        expect(Math.abs(ulps({ sin, cos, exp, log }[f](x), Math[f](x))), `${f}(${x})`).toBeLessThanOrEqual(1);
      }
      for (const y of SPECIAL) {
        expect(Math.abs(ulps(pow(x, y), x ** y)), `${x} ** ${y}`).toBeLessThanOrEqual(1);
        expect(Math.abs(ulps(atan2(x, y), Math.atan2(x, y))), `atan2(${x}, ${y})`).toBeLessThanOrEqual(1);
      }
    }
  });
});

function at(x: number, f: (x: number) => number, g: (x: number) => number): readonly [number, number] {
  return [f(x), g(x)];
}
