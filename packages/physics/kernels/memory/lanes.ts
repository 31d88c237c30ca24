// Definitions shared by all kernels: the number of `real` lanes per vector and the byte offset of a row. `real` is f32
// or f64, chosen when the module is compiled.
//
// Kernels process rows [first, last) with bounds that are multiples of 16, and rows without a body hold zeros. So no
// kernel needs a scalar tail or a mask for holes: processing an empty row has no effect.

// @ts-ignore: decorator
@inline export const LANES: i32 = 16 / sizeof<real>();

// Rows of four vectors. A kernel with little work per row processes one block at a time, at constant offsets from one
// address, which saves three quarters of the address arithmetic and of the tests for rare events.
// @ts-ignore: decorator
@inline export const BLOCK: i32 = 4 * LANES;

// @ts-ignore: decorator
@inline export function at(row: i32): usize {
  return <usize>row * sizeof<real>();
}

// @ts-ignore: decorator
@inline export function splat(value: real): v128 {
  return v128.splat<real>(value);
}

// @ts-ignore: decorator
@inline export function add(a: v128, b: v128): v128 {
  return v128.add<real>(a, b);
}

// @ts-ignore: decorator
@inline export function sub(a: v128, b: v128): v128 {
  return v128.sub<real>(a, b);
}

// @ts-ignore: decorator
@inline export function mul(a: v128, b: v128): v128 {
  return v128.mul<real>(a, b);
}

// @ts-ignore: decorator
@inline export function div(a: v128, b: v128): v128 {
  return v128.div<real>(a, b);
}

// The larger of two values that are not NaN: one instruction instead of the nine of `max`, which handles NaN and -0.
// @ts-ignore: decorator
@inline export function larger(a: v128, b: v128): v128 {
  return v128.pmax<real>(a, b);
}

// The smaller of two values, as short. In both, where `a` is NaN the result is NaN, and where only `b` is, it is `a`.
// @ts-ignore: decorator
@inline export function smaller(a: v128, b: v128): v128 {
  return v128.pmin<real>(a, b);
}

// Dot product of two vectors.
// @ts-ignore: decorator
@inline export function dot(ax: v128, ay: v128, az: v128, bx: v128, by: v128, bz: v128): v128 {
  return add(add(mul(ax, bx), mul(ay, by)), mul(az, bz));
}

// Acceleration of a body by a force: F / m, and zero where m is zero (without Mass, forces do not move the body).
// @ts-ignore: decorator
@inline export function accelerationOf(force: v128, mass: v128): v128 {
  return v128.and(div(force, mass), v128.gt<real>(mass, splat(0)));
}

// One lane of a vector, selected at run time.
// @ts-ignore: decorator
@inline export function laneOf(v: v128, lane: i32): real {
  if (lane == 0) return v128.extract_lane<real>(v, 0);
  if (sizeof<real>() == 8 || lane == 1) return v128.extract_lane<real>(v, 1);
  return lane == 2 ? <real>f32x4.extract_lane(v, 2) : <real>f32x4.extract_lane(v, 3);
}
