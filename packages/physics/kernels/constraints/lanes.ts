// LANES values of a column at once, at the rows that as many words name.

// The row named by word `i`.
// @ts-ignore: decorator
@inline function row(rows: usize, i: i32): usize {
  return <usize>load<u32>(rows + ((<usize>i) << 2)) * sizeof<real>();
}

// Whether the rows follow each other: then the column can be read and written there as a vector.
// @ts-ignore: decorator
@inline export function isRun(rows: usize): bool {
  const first = load<u32>(rows);
  if (sizeof<real>() == 8) return load<u32>(rows, 4) == first + 1;
  return i32x4.all_true(i32x4.eq(v128.load(rows), i32x4.add(i32x4.splat(first), i32x4(0, 1, 2, 3))));
}

// Whether the rows here are n, n + 1, n + 4, n + 5 and those there the ones between: springs from each node of a row to
// the next but one. In f64 rows like these follow each other anyway.
// @ts-ignore: decorator
@inline export function isWoven(here: usize, there: usize): bool {
  if (sizeof<real>() == 8) return false;
  const n = i32x4.splat(load<u32>(here));
  const strays = v128.or(
    v128.xor(v128.load(here), i32x4.add(n, i32x4(0, 1, 4, 5))),
    v128.xor(v128.load(there), i32x4.add(n, i32x4(2, 3, 6, 7))),
  );
  return !v128.any_true(strays);
}

// How the bodies of LANES rows stand: both ends follow each other, or are woven, or neither.
export const RUNS: u32 = 1;
export const WOVEN: u32 = 2;

export function kindOf(a: usize, b: usize): u32 {
  return isRun(a) && isRun(b) ? RUNS : isWoven(a, b) ? WOVEN : 0;
}

// The first halves of two vectors, and the second halves.
// @ts-ignore: decorator
@inline export function firsts(v: v128, w: v128): v128 {
  return v128.shuffle<i64>(v, w, 0, 2);
}

// @ts-ignore: decorator
@inline export function seconds(v: v128, w: v128): v128 {
  return v128.shuffle<i64>(v, w, 1, 3);
}

// @ts-ignore: decorator
@inline export function pick(column: usize, rows: usize): v128 {
  const v = v128.splat<real>(0);
  if (sizeof<real>() == 8) {
    return v128.load_lane<f64>(column + row(rows, 1), v128.load_lane<f64>(column + row(rows, 0), v, 0), 1);
  }
  const low = v128.load_lane<f32>(column + row(rows, 1), v128.load_lane<f32>(column + row(rows, 0), v, 0), 1);
  return v128.load_lane<f32>(column + row(rows, 3), v128.load_lane<f32>(column + row(rows, 2), low, 2), 3);
}

// @ts-ignore: decorator
@inline export function drop(column: usize, rows: usize, v: v128): void {
  if (sizeof<real>() == 8) {
    v128.store_lane<f64>(column + row(rows, 0), v, 0);
    v128.store_lane<f64>(column + row(rows, 1), v, 1);
    return;
  }
  v128.store_lane<f32>(column + row(rows, 0), v, 0);
  v128.store_lane<f32>(column + row(rows, 1), v, 1);
  v128.store_lane<f32>(column + row(rows, 2), v, 2);
  v128.store_lane<f32>(column + row(rows, 3), v, 3);
}

// Lanes whose row only pulls: their length carries the sign.
// @ts-ignore: decorator
@inline export function cords(length: v128): v128 {
  return sizeof<real>() == 4 ? i32x4.shr_s(length, 31) : i64x2.shr_s(length, 63);
}
