// Vectors in the plane in f64: x and y are the two lanes of a 128-bit vector.

// @ts-ignore: decorator
@inline export function vector(x: f64, y: f64): v128 {
  return f64x2.replace_lane(f64x2.splat(x), 1, y);
}

// @ts-ignore: decorator
@inline export function xOf(v: v128): f64 {
  return f64x2.extract_lane(v, 0);
}

// @ts-ignore: decorator
@inline export function yOf(v: v128): f64 {
  return f64x2.extract_lane(v, 1);
}

// @ts-ignore: decorator
@inline export function plus(a: v128, b: v128): v128 {
  return f64x2.add(a, b);
}

// @ts-ignore: decorator
@inline export function minus(a: v128, b: v128): v128 {
  return f64x2.sub(a, b);
}

// @ts-ignore: decorator
@inline export function times(factor: f64, v: v128): v128 {
  return f64x2.mul(f64x2.splat(factor), v);
}

// @ts-ignore: decorator
@inline export function dot2(a: v128, b: v128): f64 {
  const products = f64x2.mul(a, b);
  return xOf(products) + yOf(products);
}

// Turned by a quarter to the left: (-y, x), and to the right: (y, -x).
// @ts-ignore: decorator
@inline export function turnedLeft(v: v128): v128 {
  return v128.xor(v128.shuffle<f64>(v, v, 1, 0), i64x2(i64.MIN_VALUE, 0));
}

// @ts-ignore: decorator
@inline export function turnedRight(v: v128): v128 {
  return v128.xor(v128.shuffle<f64>(v, v, 1, 0), i64x2(0, i64.MIN_VALUE));
}

// A vector times a matrix with the columns (a, b) and (c, d).
// @ts-ignore: decorator
@inline export function transformed(ab: v128, cd: v128, v: v128): v128 {
  return plus(f64x2.mul(ab, v128.shuffle<f64>(v, v, 0, 0)), f64x2.mul(cd, v128.shuffle<f64>(v, v, 1, 1)));
}

// Turned by an angle with this cosine and sine.
// @ts-ignore: decorator
@inline export function turnedBy(cosineSine: v128, v: v128): v128 {
  const cosine = v128.shuffle<f64>(cosineSine, cosineSine, 0, 0);
  const sine = v128.shuffle<f64>(cosineSine, cosineSine, 1, 1);
  return plus(f64x2.mul(cosine, v), f64x2.mul(sine, turnedLeft(v)));
}

// Reads and writes two reals, of either precision.
// @ts-ignore: decorator
@inline export function loadReals(address: usize): v128 {
  return sizeof<real>() == 4 ? f64x2.promote_low_f32x4(v128.load64_zero(address)) : v128.load(address);
}

// @ts-ignore: decorator
@inline export function storeReals(address: usize, v: v128): void {
  if (sizeof<real>() == 4) v128.store64_lane(address, f32x4.demote_f64x2_zero(v), 0);
  else v128.store(address, v);
}
