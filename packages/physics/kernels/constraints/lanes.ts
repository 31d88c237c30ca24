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
