// Elementary functions from + - * / and bit operations only: the same bits on every engine, in both builds, always f64.
// src/math/elementary.ts exposes them to TypeScript, so there is only one implementation.
//
// Sine, cosine and arc tangent are AssemblyScript's, after FreeBSD msun (Sun Microsystems 1993), within 1 ulp; angles
// of any size are reduced (Payne, Hanek 1983), beyond a million radians within 2 ulp. AssemblyScript's exp, log and pow
// would add 10 KB of tables.

export function sine(x: f64): f64 {
  return NativeMath.sin(x);
}

export function cosine(x: f64): f64 {
  return NativeMath.cos(x);
}

export function arcTangent2(y: f64, x: f64): f64 {
  return NativeMath.atan2(y, x);
}

@unmanaged
class SineCosine {
  cosine: f64;
  sine: f64;
}

// Results of the last call of `computeSineCosine`.
export const sineCosine = changetype<SineCosine>(memory.data(offsetof<SineCosine>(), 8));

// The argument reduction of fdlibm begins beyond this angle, just above pi / 4.
const REDUCED: f64 = reinterpret<f64>(0x3fe921fc00000000);

// pi / 2 in three parts of 33 bits, each followed by the remainder after it.
const HALF_PI_1: f64 = reinterpret<f64>(0x3ff921fb54400000);
const HALF_PI_TAIL_1: f64 = reinterpret<f64>(0x3dd0b4611a626331);
const HALF_PI_2: f64 = reinterpret<f64>(0x3dd0b4611a600000);
const HALF_PI_TAIL_2: f64 = reinterpret<f64>(0x3ba3198a2e037073);
const HALF_PI_3: f64 = reinterpret<f64>(0x3ba3198a2e000000);
const HALF_PI_TAIL_3: f64 = reinterpret<f64>(0x397b839a252049c1);

function exponentBits(x: f64): i32 {
  return <i32>((reinterpret<u64>(x) >> 52) & 0x7ff);
}

// Computes sine and cosine of one angle within a million radians, with the same bits as `sine` and `cosine`, by the
// methods of fdlibm e_rem_pio2.c, k_sin.c and k_cos.c (Sun 1993), without the table that larger angles need.
export function computeSineCosine(angle: f64): void {
  let quarters: f64 = 0;
  let high = angle;
  let low: f64 = 0;
  if (abs<f64>(angle) >= REDUCED) {
    quarters = nearest<f64>(angle * 0.63661977236758134308);
    let remainder = angle - quarters * HALF_PI_1;
    let next = quarters * HALF_PI_TAIL_1;
    high = remainder - next;
    // More cancelled bits in the subtraction require more parts of pi.
    if (exponentBits(angle) - exponentBits(high) > 16) {
      let previous = remainder;
      next = quarters * HALF_PI_2;
      remainder = previous - next;
      next = quarters * HALF_PI_TAIL_2 - (previous - remainder - next);
      high = remainder - next;
      if (exponentBits(angle) - exponentBits(high) > 49) {
        previous = remainder;
        next = quarters * HALF_PI_3;
        remainder = previous - next;
        next = quarters * HALF_PI_TAIL_3 - (previous - remainder - next);
        high = remainder - next;
      }
    }
    low = remainder - high - next;
  }
  const z = high * high;
  const w = z * z;
  const r =
    8.33333333332248946124e-3 +
    z * (-1.98412698298579493134e-4 + z * 2.75573137070700676789e-6) +
    z * w * (-2.50507602534068634195e-8 + z * 1.58969099521155010221e-10);
  const v = z * high;
  let s = high - (z * (0.5 * low - v * r) - low + v * 1.66666666666666324348e-1);
  if (quarters == 0) s = abs<f64>(high) < 1e-8 ? high : high + v * (-1.66666666666666324348e-1 + z * r);
  const t =
    z * (4.16666666666666019037e-2 + z * (-1.38888888888741095749e-3 + z * 2.48015872894767294178e-5)) +
    w * w * (-2.75573143513906633035e-7 + z * (2.0875723212981748279e-9 + z * -1.13596475577881948265e-11));
  const half = 0.5 * z;
  const one = 1 - half;
  const c = one + (1 - one - half + (z * t - high * low));
  turn(s, c, quarters);
}

// Added to an integer below 2^51, this leaves its two's complement in the lowest bits.
const INTEGER_BITS: f64 = 6755399441055744;

// Turns a sine and cosine by quarters of a circle, without branches, which the processor could not foresee.
// @ts-ignore: decorator
@inline function turn(sine: f64, cosine: f64, quarters: f64): void {
  const bits = reinterpret<u64>(quarters + INTEGER_BITS);
  const s = reinterpret<u64>(sine);
  const c = reinterpret<u64>(cosine);
  const exchange = (s ^ c) & (0 - (bits & 1));
  sineCosine.sine = reinterpret<f64>(s ^ exchange ^ ((bits & 2) << 62));
  sineCosine.cosine = reinterpret<f64>(c ^ exchange ^ (((bits + 1) & 2) << 62));
}

// ln 2 = LN2_HIGH + LN2_LOW; the high part has 33 bits, so that k LN2_HIGH is exact for every exponent k.
export const LN2_HIGH: f64 = 6.9314718036912381649e-1;
export const LN2_LOW: f64 = 1.90821492927058770002e-10;

// exp(high + low) for |low| far below an ulp of `high`; method and coefficients of fdlibm e_exp.c (Sun 1993):
// x = k ln 2 + r with |r| <= ln 2 / 2, then a rational approximation of exp(r) with error below 2^-59.
export function exponentialOfSum(high: f64, low: f64): f64 {
  if (!(high <= 709.782712893384)) return high != high ? high : Infinity;
  if (high < -745.2) return 0;
  const k = nearest<f64>(high * 1.442695040888963387);
  const hi = high - k * LN2_HIGH;
  const lo = k * LN2_LOW - low;
  const r = hi - lo;
  const z = r * r;
  const c =
    r -
    z *
      (1.66666666666666019037e-1 +
        z *
          (-2.77777777770155933842e-3 +
            z * (6.61375632143793436117e-5 + z * (-1.6533902205465251539e-6 + z * 4.13813679705723846039e-8))));
  return NativeMath.scalbn(1 + ((r * c) / (2 - c) - lo + hi), <i32>k);
}

export function exponential(x: f64): f64 {
  return exponentialOfSum(x, 0);
}

// Natural logarithm; method and coefficients of fdlibm e_log.c (Sun 1993), error below 1 ulp.
export function logarithm(x: f64): f64 {
  if (!(x > 0)) return x == 0 ? -Infinity : NaN;
  if (x == Infinity) return x;
  const k = exponentOf(x);
  const f = NativeMath.scalbn(x, -k) - 1;
  const half = 0.5 * f * f;
  const s = f / (2 + f);
  const z = s * s;
  const w = z * z;
  const even = w * (3.999999999940941908e-1 + w * (2.222219843214978396e-1 + w * 1.531383769920937332e-1));
  const odd =
    z *
    (6.66666666666673513e-1 +
      w * (2.857142874366239149e-1 + w * (1.818357216161805012e-1 + w * 1.479819860511658591e-1)));
  const dk = <f64>k;
  return s * (half + (odd + even)) + dk * LN2_LOW - half + f + dk * LN2_HIGH;
}

// Returns the k for which x 2^-k lies between sqrt(1/2) and sqrt(2); x is positive and finite.
export function exponentOf(x: f64): i32 {
  const small = x < 2.2250738585072014e-308;
  const bits = reinterpret<u64>(small ? x * 18014398509481984 : x);
  const high = <u32>(bits >> 32) + (0x3ff00000 - 0x3fe6a09e);
  return <i32>(high >> 20) - 0x3ff - (small ? 54 : 0);
}
