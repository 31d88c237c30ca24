// The bodies that LANES words name, brought together. A body is packed as x, y, z, inverse mass, one after the other: in f32
// a vector, in f64 two. Four vectors hold LANES bodies; turned, they are x, y, z and inverse mass of all, and turned again
// the bodies.

// Ends closer than this have no direction between them: x is taken. The square of their distance, m², and its root.
export const NEAR: real = 1e-30;
export const NEAR_ROOT: real = 1e-15;

// Where the k-th of the four vectors stands.
// @ts-ignore: decorator
@inline export function placeOf(packed: usize, ids: usize, k: i32): usize {
  if (sizeof<real>() == 4) return packed + ((<usize>load<u32>(ids + ((<usize>k) << 2))) << 4);
  return packed + ((<usize>load<u32>(ids + ((<usize>(k & 1)) << 2))) << 5) + ((<usize>(k >> 1)) << 4);
}

// @ts-ignore: decorator
@inline export function turned0(a: v128, b: v128, c: v128, d: v128): v128 {
  return sizeof<real>() == 4 ? firsts(lows(a, b), lows(c, d)) : firsts(a, b);
}

// @ts-ignore: decorator
@inline export function turned1(a: v128, b: v128, c: v128, d: v128): v128 {
  return sizeof<real>() == 4 ? seconds(lows(a, b), lows(c, d)) : seconds(a, b);
}

// @ts-ignore: decorator
@inline export function turned2(a: v128, b: v128, c: v128, d: v128): v128 {
  return sizeof<real>() == 4 ? firsts(highs(a, b), highs(c, d)) : firsts(c, d);
}

// @ts-ignore: decorator
@inline export function turned3(a: v128, b: v128, c: v128, d: v128): v128 {
  return sizeof<real>() == 4 ? seconds(highs(a, b), highs(c, d)) : seconds(c, d);
}

// @ts-ignore: decorator
@inline function firsts(v: v128, w: v128): v128 {
  return v128.shuffle<i64>(v, w, 0, 2);
}

// @ts-ignore: decorator
@inline function seconds(v: v128, w: v128): v128 {
  return v128.shuffle<i64>(v, w, 1, 3);
}

// @ts-ignore: decorator
@inline function lows(v: v128, w: v128): v128 {
  return v128.shuffle<i32>(v, w, 0, 4, 1, 5);
}

// @ts-ignore: decorator
@inline function highs(v: v128, w: v128): v128 {
  return v128.shuffle<i32>(v, w, 2, 6, 3, 7);
}

// Lanes whose sign is set: those of a length whose row only pulls, for that carries the sign.
// @ts-ignore: decorator
@inline export function signs(v: v128): v128 {
  return sizeof<real>() == 4 ? i32x4.shr_s(v, 31) : i64x2.shr_s(v, 63);
}
