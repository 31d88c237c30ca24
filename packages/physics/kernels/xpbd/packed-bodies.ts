// Gathers LANES bodies by id. A packed body is x, y, z, inverse mass: one vector in f32, two in f64. Four vectors
// hold LANES bodies; transposed, they are x, y, z and inverse mass of all, and transposed again the bodies.

// Ends closer than this have no direction; the x axis is used instead. The squared distance in m², and the distance
// in m.
export const MIN_SQUARE: real = 1e-30;
export const MIN_DISTANCE: real = 1e-15;

// Address of the k-th of the four vectors.
// @ts-ignore: decorator
@inline export function vectorAddress(packed: usize, ids: usize, k: i32): usize {
  if (sizeof<real>() == 4) return packed + ((<usize>load<u32>(ids + ((<usize>k) << 2))) << 4);
  return packed + ((<usize>load<u32>(ids + ((<usize>(k & 1)) << 2))) << 5) + ((<usize>(k >> 1)) << 4);
}

// @ts-ignore: decorator
@inline export function transpose0(a: v128, b: v128, c: v128, d: v128): v128 {
  return sizeof<real>() == 4 ? evenHalves(interleaveLow(a, b), interleaveLow(c, d)) : evenHalves(a, b);
}

// @ts-ignore: decorator
@inline export function transpose1(a: v128, b: v128, c: v128, d: v128): v128 {
  return sizeof<real>() == 4 ? oddHalves(interleaveLow(a, b), interleaveLow(c, d)) : oddHalves(a, b);
}

// @ts-ignore: decorator
@inline export function transpose2(a: v128, b: v128, c: v128, d: v128): v128 {
  return sizeof<real>() == 4 ? evenHalves(interleaveHigh(a, b), interleaveHigh(c, d)) : evenHalves(c, d);
}

// @ts-ignore: decorator
@inline export function transpose3(a: v128, b: v128, c: v128, d: v128): v128 {
  return sizeof<real>() == 4 ? oddHalves(interleaveHigh(a, b), interleaveHigh(c, d)) : oddHalves(c, d);
}

// @ts-ignore: decorator
@inline function evenHalves(v: v128, w: v128): v128 {
  return v128.shuffle<i64>(v, w, 0, 2);
}

// @ts-ignore: decorator
@inline function oddHalves(v: v128, w: v128): v128 {
  return v128.shuffle<i64>(v, w, 1, 3);
}

// @ts-ignore: decorator
@inline function interleaveLow(v: v128, w: v128): v128 {
  return v128.shuffle<i32>(v, w, 0, 4, 1, 5);
}

// @ts-ignore: decorator
@inline function interleaveHigh(v: v128, w: v128): v128 {
  return v128.shuffle<i32>(v, w, 2, 6, 3, 7);
}

// Returns the mask of the lanes whose sign is set. Tension-only rows have a negative length.
// @ts-ignore: decorator
@inline export function signMask(v: v128): v128 {
  return sizeof<real>() == 4 ? i32x4.shr_s(v, 31) : i64x2.shr_s(v, 63);
}
