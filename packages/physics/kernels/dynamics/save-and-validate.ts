// The start and end of a step for one axis: saves the state of the bodies, and checks that every value is finite and in
// range.
import { BLOCK, LANES, at, splat } from '../memory/lanes';

// Saves position and velocity at the start of the step and returns 1 if every |x| <= maxPosition and |v| <= maxSpeed; in
// f64 it may return 0 for a value just below a limit.
// An invalid position is not saved: `previous` keeps the last valid one.
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
  let valid = i32x4.splat(-1);
  let speeds = emptyAccumulator();
  for (let row = first; row < last; row += BLOCK) {
    const o = at(row);
    const inRange = isWithin(accumulateBlock(emptyAccumulator(), x + o), limitX);
    speeds = accumulateBlock(speeds, v + o);
    copyBlock(start + o, v + o);
    if (i32x4.all_true(inRange)) {
      copyBlock(previous + o, x + o);
    } else {
      valid = v128.and(valid, inRange);
      copyValid(previous + o, x + o, limitX);
    }
  }
  return i32(i32x4.all_true(v128.and(valid, isWithin(speeds, limitV))));
}

// Returns 1 if every |x| <= maxPosition and |v| <= maxSpeed; in f64 it may return 0 for a value just below a limit.
export function checkAxis(x: usize, v: usize, maxPosition: real, maxSpeed: real, first: i32, last: i32): i32 {
  const limitX = splat(maxPosition);
  const limitV = splat(maxSpeed);
  let positions = emptyAccumulator();
  let speeds = emptyAccumulator();
  for (let row = first; row < last; row += BLOCK) {
    const o = at(row);
    positions = accumulateBlock(positions, x + o);
    speeds = accumulateBlock(speeds, v + o);
  }
  return i32(i32x4.all_true(v128.and(isWithin(positions, limitX), isWithin(speeds, limitV))));
}

// The accumulator of the checks: the largest magnitude per lane. Magnitudes are compared as integers, which orders NaN
// above infinity above all numbers. There is no such instruction for 64-bit integers, so in f64 the upper halves are
// compared: sign, exponent and 20 bits of the fraction.
// @ts-ignore: decorator
@inline function emptyAccumulator(): v128 {
  return i32x4.splat(0);
}

// @ts-ignore: decorator
@inline function accumulate(accumulated: v128, values: usize): v128 {
  const magnitude = sizeof<real>() == 4 ? i32x4.splat(0x7fffffff) : i64x2.splat(0x7fffffff00000000);
  return v128.max<u32>(accumulated, v128.and(v128.load(values), magnitude));
}

// @ts-ignore: decorator
@inline function accumulateBlock(accumulated: v128, p: usize): v128 {
  return accumulate(accumulate(accumulate(accumulate(accumulated, p), p + 16), p + 32), p + 48);
}

// Returns a mask of the lanes whose values are all within the limit.
// @ts-ignore: decorator
@inline function isWithin(accumulated: v128, limit: v128): v128 {
  if (sizeof<real>() == 4) return v128.le<u32>(accumulated, limit);
  return v128.lt<u32>(accumulated, v128.or(limit, i64x2.splat(0xffffffff)));
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

// Copies the values of a block that are within the limit.
function copyValid(to: usize, from: usize, limit: v128): void {
  for (let o: usize = 0; o < 64; o += 16) {
    const value = v128.load(from + o);
    v128.store(to + o, v128.bitselect(value, v128.load(to + o), v128.le<real>(v128.abs<real>(value), limit)));
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

// Returns 1 if every value is 0, as in rows without the component, or in [min, max]. NaN is not.
export function isColumnWithin(column: usize, min: real, max: real, first: i32, last: i32): i32 {
  if (min <= 0 && max >= 0) return isInRange(column, min, max, false, first, last);
  return isInRange(column, min, max, true, first, last);
}

// @ts-ignore: decorator
@inline function isInRange(column: usize, min: real, max: real, orZero: bool, first: i32, last: i32): i32 {
  const low = splat(min);
  const high = splat(max);
  let valid = i32x4.splat(-1);
  const end = column + at(last);
  for (let p = column + at(first); p < end; p += 64) {
    valid = v128.and(valid, areWithin(v128.load(p), low, high, orZero));
    valid = v128.and(valid, areWithin(v128.load(p, 16), low, high, orZero));
    valid = v128.and(valid, areWithin(v128.load(p, 32), low, high, orZero));
    valid = v128.and(valid, areWithin(v128.load(p, 48), low, high, orZero));
  }
  return i32(i32x4.all_true(valid));
}

// @ts-ignore: decorator
@inline function areWithin(value: v128, low: v128, high: v128, orZero: bool): v128 {
  const inRange = v128.and(v128.ge<real>(value, low), v128.le<real>(value, high));
  return orZero ? v128.or(inRange, v128.eq<real>(value, splat(0))) : inRange;
}
