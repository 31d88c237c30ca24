// The inner loops of the Gauss-Radau scheme of order 15: src/integrators/gauss-radau.ts.
//
// Within a step of length dt the acceleration is a(h) = a0 + b0 h + b1 h^2 + ... + b6 h^7, h from 0 to 1. The same
// polynomial in Newton's form has divided differences g0 ... g6, of which g[s-1] depends only on the first s nodes.
import { accelerationOf, add, at, LANES, mul, splat, sub } from '../memory/lanes';

// Offsets of the columns of an axis in its block, in columns.
const B: usize = 0;
const G: usize = 7;
const A0: usize = 14;
const START_X: usize = 15;
const START_V: usize = 16;
const CARRY_X: usize = 17;
const CARRY_V: usize = 18;

// The record of a world's integrator; src/integrators/support/gauss-radau-table.ts writes it.
@unmanaged
export class RadauTable {
  positionX: usize;
  positionY: usize;
  positionZ: usize;
  velocityX: usize;
  velocityY: usize;
  velocityZ: usize;
  forceX: usize;
  forceY: usize;
  forceZ: usize;
  blockX: usize;
  blockY: usize;
  blockZ: usize;
  mass: usize;
  stride: usize;
  axes: usize;
  // Reals: per node 8 weights for x and 8 for v; per node the reciprocals of its distances to the earlier nodes (8);
  // the 7 x 7 coefficients that convert a divided difference to powers of h.
  weights: usize;
  reciprocals: usize;
  powers: usize;
}

// @ts-ignore: decorator
@inline function axisOf(table: usize, field: usize, axis: usize): usize {
  return load<usize>(table + field + (axis << 2));
}

// @ts-ignore: decorator
@inline function constant(column: usize, index: i32): v128 {
  return v128.load_splat<real>(column + at(index));
}

// Saves the state at the start of a step, and its acceleration.
export function radauBegin(table: usize, first: i32, last: i32): void {
  const t = changetype<RadauTable>(table);
  for (let axis: usize = 0; axis < t.axes; axis++) {
    const block = axisOf(table, offsetof<RadauTable>('blockX'), axis);
    const force = axisOf(table, offsetof<RadauTable>('forceX'), axis);
    const x = axisOf(table, offsetof<RadauTable>('positionX'), axis);
    const v = axisOf(table, offsetof<RadauTable>('velocityX'), axis);
    for (let row = first; row < last; row += LANES) {
      const o = at(row);
      v128.store(block + A0 * t.stride + o, accelerationOf(v128.load(force + o), v128.load(t.mass + o)));
      saveStart(block + o, START_X, CARRY_X, t.stride, v128.load(x + o));
      saveStart(block + o, START_V, CARRY_V, t.stride, v128.load(v + o));
    }
  }
}

// Keeps the rounding error only if it is plausible for this value: the body may have been moved since.
// @ts-ignore: decorator
@inline function saveStart(block: usize, start: usize, carry: usize, stride: usize, value: v128): void {
  const carryAddress = block + carry * stride;
  const carried = v128.load(carryAddress);
  const maxCarry = mul(v128.abs<real>(value), splat(sizeof<real>() == 4 ? <real>1.2e-7 : <real>2.3e-16));
  v128.store(carryAddress, v128.and(carried, v128.le<real>(v128.abs<real>(carried), maxCarry)));
  v128.store(block + start * stride, value);
}

// Moves the bodies to the positions of the polynomial at a node; node 8 is the end of the step.
export function radauState(table: usize, node: i32, h: f64, dt: f64, first: i32, last: i32): void {
  const t = changetype<RadauTable>(table);
  const w = t.weights + at(node << 4);
  const time = splat(<real>(h * dt));
  const step = splat(<real>dt);
  for (let axis: usize = 0; axis < t.axes; axis++) {
    const block = axisOf(table, offsetof<RadauTable>('blockX'), axis);
    const x = axisOf(table, offsetof<RadauTable>('positionX'), axis);
    const v = axisOf(table, offsetof<RadauTable>('velocityX'), axis);
    for (let row = first; row < last; row += LANES) {
      const start = block + at(row);
      const v0 = v128.load(start + START_V * t.stride);
      const dx = mul(weightedSum(start, t.stride, w), step);
      const dv = mul(weightedSum(start, t.stride, w + at(8)), step);
      const moved = add(mul(v0, time), mul(dx, step));
      v128.store(
        x + at(row),
        add(v128.load(start + START_X * t.stride), sub(moved, v128.load(start + CARRY_X * t.stride))),
      );
      v128.store(v + at(row), add(v0, sub(dv, v128.load(start + CARRY_V * t.stride))));
    }
  }
}

// w7 b6 + ... + w1 b0 + w0 a0, summed from the smallest term.
// @ts-ignore: decorator
@inline function weightedSum(start: usize, stride: usize, w: usize): v128 {
  let sum = mul(v128.load(start + 6 * stride), constant(w, 7));
  sum = add(sum, mul(v128.load(start + 5 * stride), constant(w, 6)));
  sum = add(sum, mul(v128.load(start + 4 * stride), constant(w, 5)));
  sum = add(sum, mul(v128.load(start + 3 * stride), constant(w, 4)));
  sum = add(sum, mul(v128.load(start + 2 * stride), constant(w, 3)));
  sum = add(sum, mul(v128.load(start + stride), constant(w, 2)));
  sum = add(sum, mul(v128.load(start), constant(w, 1)));
  return add(sum, mul(v128.load(start + A0 * stride), constant(w, 0)));
}

// The largest |a| in the last call of `radauRefine`.
let largest: f64 = 0;

export function radauLargest(): f64 {
  return largest;
}

// Updates the divided difference of node s from the force, and with it b0 ... b[s-1]. Returns the largest change of
// the difference, infinite if a value is not finite.
export function radauRefine(table: usize, s: i32, first: i32, last: i32): f64 {
  const t = changetype<RadauTable>(table);
  const reciprocals = t.reciprocals + at(s << 3);
  const powers = t.powers + at(7 * (s - 1));
  let change = splat(0);
  let largestValue = splat(0);
  for (let axis: usize = 0; axis < t.axes; axis++) {
    const block = axisOf(table, offsetof<RadauTable>('blockX'), axis);
    const force = axisOf(table, offsetof<RadauTable>('forceX'), axis);
    for (let row = first; row < last; row += LANES) {
      const o = at(row);
      const start = block + o;
      const a = accelerationOf(v128.load(force + o), v128.load(t.mass + o));
      let r = mul(sub(a, v128.load(start + A0 * t.stride)), constant(reciprocals, 0));
      let g = start + G * t.stride;
      for (let k = 1; k < s; k++) {
        r = mul(sub(r, v128.load(g)), constant(reciprocals, k));
        g += t.stride;
      }
      const d = sub(r, v128.load(g));
      v128.store(g, r);
      let b = start;
      for (let m = 0; m < s; m++) {
        v128.store(b, add(v128.load(b), mul(d, constant(powers, m))));
        b += t.stride;
      }
      change = v128.max<real>(change, v128.abs<real>(d));
      largestValue = v128.max<real>(largestValue, v128.abs<real>(a));
    }
  }
  largest = largestLane(largestValue);
  return largestLane(change);
}

// f64x2.max and f32x4.max propagate NaN, so one comparison at the end detects it.
// @ts-ignore: decorator
@inline function largestLane(v: v128): f64 {
  let largestValue: f64 = max<f64>(v128.extract_lane<real>(v, 0), v128.extract_lane<real>(v, 1));
  if (sizeof<real>() == 4) {
    largestValue = max<f64>(largestValue, max<f64>(f32x4.extract_lane(v, 2), f32x4.extract_lane(v, 3)));
  }
  return largestValue < Infinity ? largestValue : Infinity;
}

// Returns the largest magnitude in a column: 6 for b6, which measures convergence.
export function radauLargestOf(table: usize, column: i32, first: i32, last: i32): f64 {
  const t = changetype<RadauTable>(table);
  let largestValue = splat(0);
  for (let axis: usize = 0; axis < t.axes; axis++) {
    const values = axisOf(table, offsetof<RadauTable>('blockX'), axis) + <usize>column * t.stride;
    for (let row = first; row < last; row += LANES) {
      largestValue = v128.max<real>(largestValue, v128.abs<real>(v128.load(values + at(row))));
    }
  }
  return largestLane(largestValue);
}

// Returns the movable body whose |b6| is largest, or not finite.
export function radauWorstRow(table: usize, first: i32, last: i32): i32 {
  const t = changetype<RadauTable>(table);
  let worstRow = 0;
  let largestValue: f64 = -1;
  for (let row = first; row < last; row++) {
    if (!(load<real>(t.mass + at(row)) > 0)) continue;
    for (let axis: usize = 0; axis < t.axes; axis++) {
      const b6 = axisOf(table, offsetof<RadauTable>('blockX'), axis) + 6 * t.stride;
      const magnitude = <f64>abs<real>(load<real>(b6 + at(row)));
      if (magnitude > largestValue || magnitude != magnitude) {
        if (magnitude != magnitude) return row;
        largestValue = magnitude;
        worstRow = row;
      }
    }
  }
  return worstRow;
}

// Predicts the polynomial of the next step from the last: `ratio` is the ratio of their lengths. With `advances` the
// next step begins at the end of the last; without, at its start (a repeated step).
export function radauPredict(table: usize, ratio: f64, advances: bool, first: i32, last: i32): void {
  const t = changetype<RadauTable>(table);
  for (let axis: usize = 0; axis < t.axes; axis++) {
    const block = axisOf(table, offsetof<RadauTable>('blockX'), axis);
    for (let row = first; row < last; row += LANES) {
      const start = block + at(row);
      if (advances) shiftToEnd(start, t.stride);
      let q: f64 = 1;
      for (let k: usize = 0; k < 7; k++) {
        q *= ratio;
        const b = start + k * t.stride;
        v128.store(b, mul(v128.load(b), splat(<real>q)));
      }
    }
    for (let row = first; row < last; row += LANES) differences(t, block + at(row));
  }
}

// Shifts the origin to h = 1: b[k] = sum over j >= k of (j+1 over k+1) b[j], by repeated addition: one pass through
// all terms for a0, which is not stored, then one for b0, b1, and so on.
// @ts-ignore: decorator
@inline function shiftToEnd(start: usize, stride: usize): void {
  for (let pass: usize = 0; pass < 7; pass++) {
    const lowest: usize = pass == 0 ? 0 : pass - 1;
    let sum = v128.load(start + 6 * stride);
    for (let j: usize = 6; j-- > lowest; ) {
      const b = start + j * stride;
      sum = add(sum, v128.load(b));
      v128.store(b, sum);
    }
  }
}

// Computes g from b, highest power first.
// @ts-ignore: decorator
@inline function differences(t: RadauTable, start: usize): void {
  const g = start + G * t.stride;
  for (let k: usize = 0; k < 7; k++) v128.store(g + k * t.stride, v128.load(start + k * t.stride));
  for (let k = 6; k > 0; k--) {
    const d = v128.load(g + <usize>k * t.stride);
    const powers = t.powers + at(7 * k);
    for (let m = 0; m < k; m++) {
      const below = g + <usize>m * t.stride;
      v128.store(below, sub(v128.load(below), mul(d, constant(powers, m))));
    }
  }
}

// Ends a step: x and v change by the integrals of the polynomial, with compensated summation (Kahan, Comm. ACM 8, 40,
// 1965).
export function radauEnd(table: usize, dt: f64, first: i32, last: i32): void {
  const t = changetype<RadauTable>(table);
  const w = t.weights + at(8 << 4);
  const step = splat(<real>dt);
  for (let axis: usize = 0; axis < t.axes; axis++) {
    const block = axisOf(table, offsetof<RadauTable>('blockX'), axis);
    const x = axisOf(table, offsetof<RadauTable>('positionX'), axis);
    const v = axisOf(table, offsetof<RadauTable>('velocityX'), axis);
    for (let row = first; row < last; row += LANES) {
      const start = block + at(row);
      const v0 = v128.load(start + START_V * t.stride);
      const dx = mul(add(v0, mul(weightedSum(start, t.stride, w), step)), step);
      const dv = mul(weightedSum(start, t.stride, w + at(8)), step);
      addCompensated(x + at(row), v128.load(start + START_X * t.stride), dx, start + CARRY_X * t.stride);
      addCompensated(v + at(row), v0, dv, start + CARRY_V * t.stride);
    }
  }
}

// @ts-ignore: decorator
@inline function addCompensated(to: usize, from: v128, change: v128, carry: usize): void {
  const y = sub(change, v128.load(carry));
  const sum = add(from, y);
  v128.store(carry, sub(sub(sum, from), y));
  v128.store(to, sum);
}

// Clears the polynomial of the last step.
export function radauReset(table: usize, first: i32, last: i32): void {
  const t = changetype<RadauTable>(table);
  for (let axis: usize = 0; axis < t.axes; axis++) {
    const block = axisOf(table, offsetof<RadauTable>('blockX'), axis);
    for (let k: usize = 0; k < A0; k++) memory.fill(block + k * t.stride + at(first), 0, at(last - first));
  }
}
