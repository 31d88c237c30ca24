// The difference of the two solutions of an embedded pair, relative to the magnitude of each body's state.
import { add, at, LANES, mul, splat } from '../memory/lanes';

// The record of a world's error estimate; src/integrators/support/dormand-prince-stages.ts writes it.
@unmanaged
export class EmbeddedError {
  // Columns of sums over the axes.
  errorX: usize;
  errorV: usize;
  sizeX: usize;
  sizeV: usize;
  // Distance of the columns of consecutive stages in bytes, and the weights of the `count` accelerations in the
  // difference of positions and in the difference of velocities.
  stride: usize;
  weightsX: usize;
  weightsV: usize;
  count: i32;
  // Results of `worstError`: the row with the largest error, and the error.
  worstRow: i32;
  worst: f64;
  // Lower bounds of the magnitudes, m and m/s.
  floorX: f64;
  floorV: f64;
}

// Adds one axis: to `errorX` and `errorV` the squares of the differences (weighted sums of columns, as in
// combineAxis), to `sizeX` and `sizeV` the squares of the larger of the values before and after the step.
// `start` is the first column of the axis: positions at the start of the step, then velocities, then accelerations.
export function embeddedErrorAxis(table: usize, start: usize, x: usize, v: usize, first: i32, last: i32): void {
  const e = changetype<EmbeddedError>(table);
  const errorX = e.errorX;
  const errorV = e.errorV;
  const sizeX = e.sizeX;
  const sizeV = e.sizeV;
  const stride = e.stride;
  const weightsX = e.weightsX;
  const weightsV = e.weightsV;
  const count = e.count;
  const startV = start + stride;
  const accelerations = startV + stride;
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    let differenceX = splat(0);
    let differenceV = splat(0);
    let column = accelerations + o;
    for (let k = 0; k < count; k++) {
      const a = v128.load(column);
      const w = <usize>k * sizeof<real>();
      differenceX = add(differenceX, mul(a, v128.load_splat<real>(weightsX + w)));
      differenceV = add(differenceV, mul(a, v128.load_splat<real>(weightsV + w)));
      column += stride;
    }
    addSquare(errorX + o, differenceX);
    addSquare(errorV + o, differenceV);
    addSquare(sizeX + o, maxMagnitude(v128.load(x + o), v128.load(start + o)));
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

// Raises `worst` to the largest ratio of error to magnitude over all bodies, positions and velocities; infinite if a
// value is not finite. A body at rest in the origin without force has no error.
export function worstError(table: usize, first: i32, last: i32): void {
  const e = changetype<EmbeddedError>(table);
  const errorX = e.errorX;
  const errorV = e.errorV;
  const sizeX = e.sizeX;
  const sizeV = e.sizeV;
  const floorX = e.floorX;
  const floorV = e.floorV;
  let largest = e.worst * e.worst;
  for (let row = first; row < last; row++) {
    const o = at(row);
    const errorOfX = ratio(load<real>(errorX + o), load<real>(sizeX + o), floorX);
    const errorOfV = ratio(load<real>(errorV + o), load<real>(sizeV + o), floorV);
    const rowError = max<f64>(errorOfX, errorOfV);
    if (rowError > largest) {
      largest = rowError;
      e.worstRow = row;
    }
  }
  e.worst = sqrt<f64>(largest);
}

// @ts-ignore: decorator
@inline function ratio(error: f64, size: f64, floor: f64): f64 {
  if (error == 0) return 0;
  if (!(error < Infinity) || !(size < Infinity)) return Infinity;
  const scale = max<f64>(size, floor * floor);
  return scale > 0 ? error / scale : Infinity;
}
