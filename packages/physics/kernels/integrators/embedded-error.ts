// The difference of the two solutions of an embedded pair, relative to the magnitude of each body's state.
import { add, at, LANES, mul, splat } from '../memory/lanes';

// Adds one axis: to `errorX` and `errorV` the squares of the differences (weighted sums of columns, as in
// combineAxis), to `sizeX` and `sizeV` the squares of the larger of the values before and after the step.
export function embeddedErrorAxis(
  errorX: usize,
  errorV: usize,
  sizeX: usize,
  sizeV: usize,
  x: usize,
  v: usize,
  startX: usize,
  startV: usize,
  columns: usize,
  stride: usize,
  weightsX: usize,
  weightsV: usize,
  count: i32,
  first: i32,
  last: i32,
): void {
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    let differenceX = splat(0);
    let differenceV = splat(0);
    let column = columns + o;
    for (let k = 0; k < count; k++) {
      const a = v128.load(column);
      const w = <usize>k * sizeof<real>();
      differenceX = add(differenceX, mul(a, v128.load_splat<real>(weightsX + w)));
      differenceV = add(differenceV, mul(a, v128.load_splat<real>(weightsV + w)));
      column += stride;
    }
    addSquare(errorX + o, differenceX);
    addSquare(errorV + o, differenceV);
    addSquare(sizeX + o, maxMagnitude(v128.load(x + o), v128.load(startX + o)));
    addSquare(sizeV + o, maxMagnitude(v128.load(v + o), v128.load(startV + o)));
  }
}

// @ts-ignore: decorator
@inline function addSquare(sum: usize, value: v128): void {
  v128.store(sum, add(v128.load(sum), mul(value, value)));
}

// @ts-ignore: decorator
@inline function maxMagnitude(a: v128, b: v128): v128 {
  return v128.max<real>(v128.abs<real>(a), v128.abs<real>(b));
}

// The row with the largest error of the last call of `worstError`.
let worstRow: i32 = 0;

export function rowOfWorstError(): i32 {
  return worstRow;
}

// Returns the larger of `most` and the largest ratio of error to magnitude over all bodies, positions and velocities;
// infinite if a value is not finite. A body at rest in the origin without force has no error.
export function worstError(
  errorX: usize,
  errorV: usize,
  sizeX: usize,
  sizeV: usize,
  floorX: f64,
  floorV: f64,
  most: f64,
  first: i32,
  last: i32,
): f64 {
  let largest = most * most;
  for (let row = first; row < last; row++) {
    const o = at(row);
    const errorOfX = ratio(load<real>(errorX + o), load<real>(sizeX + o), floorX);
    const errorOfV = ratio(load<real>(errorV + o), load<real>(sizeV + o), floorV);
    const rowError = max<f64>(errorOfX, errorOfV);
    if (rowError > largest) {
      largest = rowError;
      worstRow = row;
    }
  }
  return sqrt<f64>(largest);
}

// @ts-ignore: decorator
@inline function ratio(error: f64, size: f64, floor: f64): f64 {
  if (error == 0) return 0;
  if (!(error < Infinity) || !(size < Infinity)) return Infinity;
  const scale = max<f64>(size, floor * floor);
  return scale > 0 ? error / scale : Infinity;
}
