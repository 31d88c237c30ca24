// The two ends of a step for one axis: remember where the bodies were, and see that every value is finite and in range.
import { BLOCK, LANES, add, at, splat } from './lanes';

// Saves position and velocity at the start of the step and returns 1 when every |x| <= maxPosition and |v| <= maxSpeed.
// The comparison is false for NaN, so one instruction finds NaN, infinity and nonsense alike. A bad position is not
// saved: `previous` keeps the last good one.
export function beginAxis(
  previous: usize,
  start: usize,
  x: usize,
  v: usize,
  maxPosition: real,
  maxSpeed: real,
  first: i32,
  last: i32,
): i32 {
  const limitX = splat(maxPosition);
  const limitV = splat(maxSpeed);
  let good = i32x4.splat(-1);
  for (let row = first; row < last; row += BLOCK) {
    const o = at(row);
    const inRange = blockWithin(x + o, limitX);
    good = v128.and(good, v128.and(inRange, blockWithin(v + o, limitV)));
    copyBlock(start + o, v + o);
    if (i32x4.all_true(inRange)) copyBlock(previous + o, x + o);
    else copyGood(previous + o, x + o, limitX);
  }
  return i32(i32x4.all_true(good));
}

// Returns 1 when every |x| <= maxPosition and |v| <= maxSpeed.
export function checkAxis(x: usize, v: usize, maxPosition: real, maxSpeed: real, first: i32, last: i32): i32 {
  const limitX = splat(maxPosition);
  const limitV = splat(maxSpeed);
  let good = i32x4.splat(-1);
  for (let row = first; row < last; row += BLOCK) {
    const o = at(row);
    good = v128.and(good, v128.and(blockWithin(x + o, limitX), blockWithin(v + o, limitV)));
  }
  return i32(i32x4.all_true(good));
}

// @ts-ignore: decorator
@inline function within(values: usize, limit: v128): v128 {
  return v128.le<real>(v128.abs<real>(v128.load(values)), limit);
}

// Lanes set where all four vectors of a block are within the limit.
// @ts-ignore: decorator
@inline function blockWithin(p: usize, limit: v128): v128 {
  return v128.and(
    v128.and(within(p, limit), within(p + 16, limit)),
    v128.and(within(p + 32, limit), within(p + 48, limit)),
  );
}

// @ts-ignore: decorator
@inline function copyBlock(to: usize, from: usize): void {
  const a = v128.load(from);
  const b = v128.load(from, 16);
  const c = v128.load(from, 32);
  const d = v128.load(from, 48);
  v128.store(to, a);
  v128.store(to, b, 16);
  v128.store(to, c, 32);
  v128.store(to, d, 48);
}

// Copies those values of a block that are within the limit.
function copyGood(to: usize, from: usize, limit: v128): void {
  for (let o: usize = 0; o < 64; o += 16) {
    const value = v128.load(from + o);
    v128.store(to + o, v128.bitselect(value, v128.load(to + o), within(from + o, limit)));
  }
}

// Fills rows of one column with zeros.
export function zeroColumn(column: usize, first: i32, last: i32): void {
  memory.fill(column + at(first), 0, at(last - first));
}

// Copies rows of one column to another.
export function copyColumn(to: usize, from: usize, first: i32, last: i32): void {
  memory.copy(to + at(first), from + at(first), at(last - first));
}

// y += x for rows of two columns.
export function addColumn(y: usize, x: usize, first: i32, last: i32): void {
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    v128.store(y + o, add(v128.load(y + o), v128.load(x + o)));
  }
}
