// The two ends of a step for one axis: remember where the bodies were, and see that every value is finite and in range.
import { LANES, add, at, splat } from './lanes';

// Saves position and velocity at the start of the step and returns 1 when every |x| <= maxPosition and |v| <= maxSpeed.
// The comparison is false for NaN, so one instruction finds NaN, infinity and nonsense alike. A bad position is not
// saved: `previous` keeps the last good one.
export function beginAxis(
  previous: usize, start: usize, x: usize, v: usize, maxPosition: real, maxSpeed: real, first: i32, last: i32,
): i32 {
  const limitX = splat(maxPosition);
  const limitV = splat(maxSpeed);
  let good = i32x4.splat(-1);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const position = v128.load(x + o);
    const velocity = v128.load(v + o);
    const inRange = v128.le<real>(v128.abs<real>(position), limitX);
    good = v128.and(good, v128.and(inRange, v128.le<real>(v128.abs<real>(velocity), limitV)));
    if (i32x4.all_true(inRange)) v128.store(previous + o, position);
    else v128.store(previous + o, v128.bitselect(position, v128.load(previous + o), inRange));
    v128.store(start + o, velocity);
  }
  return i32(i32x4.all_true(good));
}

// Returns 1 when every |x| <= maxPosition and |v| <= maxSpeed.
export function checkAxis(x: usize, v: usize, maxPosition: real, maxSpeed: real, first: i32, last: i32): i32 {
  const limitX = splat(maxPosition);
  const limitV = splat(maxSpeed);
  let good = i32x4.splat(-1);
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    good = v128.and(good, v128.and(
      v128.le<real>(v128.abs<real>(v128.load(x + o)), limitX),
      v128.le<real>(v128.abs<real>(v128.load(v + o)), limitV)));
  }
  return i32(i32x4.all_true(good));
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
