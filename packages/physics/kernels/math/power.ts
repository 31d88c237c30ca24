// x to the power y, within 1 ulp: y ln x in double-double arithmetic (Dekker, Numer. Math. 18, 224, 1971), then exp.
// Special cases follow ECMAScript's Math.pow.
import { LN2_HIGH, LN2_LOW, exponentOf, exponentialOfSum } from './elementary';

// The rounding error of the last twoProduct or twoSum.
let roundingError: f64 = 0;

function twoProduct(a: f64, b: f64): f64 {
  const product = a * b;
  const wideA = 134217729 * a;
  const wideB = 134217729 * b;
  const highA = wideA - (wideA - a);
  const highB = wideB - (wideB - b);
  const lowA = a - highA;
  const lowB = b - highB;
  roundingError = lowA * lowB - (product - highA * highB - lowA * highB - highA * lowB);
  return product;
}

function twoSum(a: f64, b: f64): f64 {
  const sum = a + b;
  const c = sum - a;
  roundingError = a - (sum - c) + (b - c);
  return sum;
}

// Low half of the last `logarithmPair`.
let logarithmLow: f64 = 0;

// ln x as high + low with a relative error near 2^-65: x = 2^k m, ln m = 2 atanh s, s = (m - 1)/(m + 1). The first two
// terms of the series are computed in double-double, the rest in double.
function logarithmPair(x: f64): f64 {
  const k = exponentOf(x);
  const f = NativeMath.scalbn(x, -k) - 1;
  const d = 2 + f;
  const s = f / d;
  const reproduced = twoProduct(s, d);
  const sLow = (f - reproduced - roundingError - s * (f - (d - 2))) / d;
  const z = twoProduct(s, s);
  const zLow = roundingError + 2 * s * sLow;
  const cube = twoProduct(s, z);
  const cubeLow = roundingError + s * zLow + sLow * z;
  const third = twoProduct(cube, 0.6666666666666666);
  const thirdLow = roundingError + cubeLow * 0.6666666666666666 + cube * 3.700743415417188e-17;
  const tail =
    cube *
    z *
    (2.0 / 5 +
      z *
        (2.0 / 7 +
          z *
            (2.0 / 9 +
              z *
                (2.0 / 11 +
                  z *
                    (2.0 / 13 + z * (2.0 / 15 + z * (2.0 / 17 + z * (2.0 / 19 + z * (2.0 / 21 + z * (2.0 / 23))))))))));
  const dk = <f64>k;
  const first = twoSum(dk * LN2_HIGH, 2 * s);
  let low = roundingError;
  const second = twoSum(first, third);
  low += roundingError + 2 * sLow + thirdLow + tail + dk * LN2_LOW;
  const high = second + low;
  logarithmLow = low - (high - second);
  return high;
}

// Returns 0 for a fraction, 1 for an odd integer, 2 for an even integer.
function parity(y: f64): i32 {
  if (abs<f64>(y) >= 9007199254740992) return 2;
  if (trunc<f64>(y) != y) return 0;
  return trunc<f64>(y * 0.5) * 2 == y ? 2 : 1;
}

export function power(x: f64, y: f64): f64 {
  if (y == 0) return 1;
  if (x != x || y != y) return NaN;
  const base = abs<f64>(x);
  if (abs<f64>(y) == Infinity) return base == 1 ? NaN : base > 1 == y > 0 ? Infinity : 0;
  const kind = parity(y);
  const sign = kind == 1 ? copysign<f64>(1, x) : 1;
  if (base == 0 || base == Infinity) return sign * ((base == 0) == y > 0 ? 0 : Infinity);
  if (x < 0 && kind == 0) return NaN;
  if (base == 1) return sign;
  const high = logarithmPair(base);
  const estimate = y * high;
  if (estimate > 710) return sign * Infinity;
  if (estimate < -746) return 0 * sign;
  const product = twoProduct(y, high);
  return sign * exponentialOfSum(product, roundingError + y * logarithmLow);
}
