// Gauss-Seidel sweeps of XPBD over the rows outside chains: first the groups of rows, then the polylines, each solved
// as a whole (polyline-batches.ts). The rows of a group share no movable body, so LANES of them are solved at once,
// with the same result as in sequence.
//
//   tension += gain (d - L) - softness tension        x_a += w_a n dtension        x_b -= w_b n dtension
//
// The tension of a tension-only row is never below zero. Ends closer than 1e-15 m have no direction; the x axis is
// used instead.
import { get, put } from '../memory/columns';
import { LANES, add, at, div, dot, mul, splat, sub } from '../memory/lanes';
import {
  MIN_DISTANCE,
  MIN_SQUARE,
  signMask,
  transpose0,
  transpose1,
  transpose2,
  transpose3,
  vectorAddress,
} from './packed-bodies';
import { orderPasses } from './passes';
import { exceedsTolerance, solveBatches } from './polyline-batches';
import { ConstraintTable, isTensionOnly, packedAt, packedComponent, putPackedComponent, tableAt, word } from './table';

// The maximum number of extra iterations of the polylines until they keep their lengths.
const MAX_EXTRA_ITERATIONS: i32 = 20;

// Runs `sweeps` Gauss-Seidel sweeps from tensions of zero. Warm starting from the last sub-step is unstable: the
// remaining error would accumulate from sub-step to sub-step.
export function sweepConstraints(table: usize, sweeps: i32): void {
  const t = tableAt(table);
  const first = t.groupsFirst;
  orderPasses(t);
  clearTensions(t, (<i32>word(t.chains, t.chainCount) + 3) & ~3, first);
  clearTensions(t, t.serialFirst, t.rowCount);
  for (let s = 0; s < sweeps; s++) {
    solveGroups(t, first, t.serialFirst, s == 0);
    for (let row = t.serialFirst; row < t.rowCount; row++) solveRow(t, row);
    solveBatches(t);
  }
  for (let iteration = 0; iteration < MAX_EXTRA_ITERATIONS && exceedsTolerance(t); iteration++) solveBatches(t);
}

function clearTensions(t: ConstraintTable, first: i32, last: i32): void {
  const size = sizeof<real>();
  if (last > first) memory.fill(t.tension + <usize>first * size, 0, <usize>(last - first) * size);
}

export function solveRow(t: ConstraintTable, row: i32): void {
  const gain = get(t.gain, row);
  if (gain == 0) return;
  const pa = packedAt(t, word(t.a, row));
  const pb = packedAt(t, word(t.b, row));
  const x = packedComponent(pb, 0) - packedComponent(pa, 0);
  const y = packedComponent(pb, 1) - packedComponent(pa, 1);
  const z = packedComponent(pb, 2) - packedComponent(pa, 2);
  const length = get(t.length, row);
  const tension = get(t.tension, row);
  let next = tension + gain * (sqrt<real>(x * x + y * y + z * z) - abs<real>(length)) - get(t.softness, row) * tension;
  if (isTensionOnly(length) && next < 0) next = 0;
  put(t.tension, row, next);
  applyTension(t, row, next - tension);
}

// Applies the positional impulse `by` of a row to its two ends.
function applyTension(t: ConstraintTable, row: i32, by: real): void {
  const pa = packedAt(t, word(t.a, row));
  const pb = packedAt(t, word(t.b, row));
  let x = packedComponent(pb, 0) - packedComponent(pa, 0);
  let y = packedComponent(pb, 1) - packedComponent(pa, 1);
  let z = packedComponent(pb, 2) - packedComponent(pa, 2);
  const square = x * x + y * y + z * z;
  let scale = by;
  if (square < MIN_SQUARE) {
    x = 1;
    y = 0;
    z = 0;
  } else scale = by / sqrt<real>(square);
  const wa = packedComponent(pa, 3) * scale;
  const wb = packedComponent(pb, 3) * scale;
  putPackedComponent(pa, 0, packedComponent(pa, 0) + wa * x);
  putPackedComponent(pa, 1, packedComponent(pa, 1) + wa * y);
  putPackedComponent(pa, 2, packedComponent(pa, 2) + wa * z);
  putPackedComponent(pb, 0, packedComponent(pb, 0) - wb * x);
  putPackedComponent(pb, 1, packedComponent(pb, 1) - wb * y);
  putPackedComponent(pb, 2, packedComponent(pb, 2) - wb * z);
}

// @ts-ignore: decorator
@inline function putBodies(p0: usize, p1: usize, p2: usize, p3: usize, x: v128, y: v128, z: v128, w: v128): void {
  v128.store(p0, transpose0(x, y, z, w));
  v128.store(p1, transpose1(x, y, z, w));
  v128.store(p2, transpose2(x, y, z, w));
  v128.store(p3, transpose3(x, y, z, w));
}

// Solves groups of LANES rows that share no movable body. If `isFirst`, the stored tensions are ignored and count as
// zero.
function solveGroups(t: ConstraintTable, first: i32, last: i32, isFirst: bool): void {
  const packed = t.packed;
  const lengths = t.length;
  const gains = t.gain;
  const softnesses = t.softness;
  const tensions = t.tension;
  let a = t.a + ((<usize>first) << 2);
  let b = t.b + ((<usize>first) << 2);
  const end = at(last);
  for (let o = at(first); o < end; o += 16) {
    const p0 = vectorAddress(packed, a, 0);
    const p1 = vectorAddress(packed, a, 1);
    const p2 = vectorAddress(packed, a, 2);
    const p3 = vectorAddress(packed, a, 3);
    const q0 = vectorAddress(packed, b, 0);
    const q1 = vectorAddress(packed, b, 1);
    const q2 = vectorAddress(packed, b, 2);
    const q3 = vectorAddress(packed, b, 3);
    const a0 = v128.load(p0);
    const a1 = v128.load(p1);
    const a2 = v128.load(p2);
    const a3 = v128.load(p3);
    const b0 = v128.load(q0);
    const b1 = v128.load(q1);
    const b2 = v128.load(q2);
    const b3 = v128.load(q3);
    const xa = transpose0(a0, a1, a2, a3);
    const ya = transpose1(a0, a1, a2, a3);
    const za = transpose2(a0, a1, a2, a3);
    const wa = transpose3(a0, a1, a2, a3);
    const xb = transpose0(b0, b1, b2, b3);
    const yb = transpose1(b0, b1, b2, b3);
    const zb = transpose2(b0, b1, b2, b3);
    const wb = transpose3(b0, b1, b2, b3);
    let x = sub(xb, xa);
    let y = sub(yb, ya);
    let z = sub(zb, za);
    let square = dot(x, y, z, x, y, z);
    const isDegenerate = v128.lt<real>(square, splat(MIN_SQUARE));
    if (i32x4.bitmask(isDegenerate) != 0) {
      x = v128.bitselect(splat(MIN_DISTANCE), x, isDegenerate);
      y = v128.andnot(y, isDegenerate);
      z = v128.andnot(z, isDegenerate);
      square = v128.bitselect(splat(MIN_SQUARE), square, isDegenerate);
    }
    const d = v128.sqrt<real>(square);
    const length = v128.load(lengths + o);
    const elastic = mul(v128.load(gains + o), sub(d, v128.abs<real>(length)));
    const tension = isFirst ? splat(0) : v128.load(tensions + o);
    const wanted = isFirst ? elastic : add(sub(tension, mul(v128.load(softnesses + o), tension)), elastic);
    const newTension = v128.andnot(wanted, signMask(v128.and(wanted, length)));
    v128.store(tensions + o, newTension);
    const scale = div(isFirst ? newTension : sub(newTension, tension), d);
    const byA = mul(wa, scale);
    const byB = mul(wb, scale);
    const toXa = add(xa, mul(byA, x));
    const toYa = add(ya, mul(byA, y));
    const toZa = add(za, mul(byA, z));
    const toXb = sub(xb, mul(byB, x));
    const toYb = sub(yb, mul(byB, y));
    const toZb = sub(zb, mul(byB, z));
    putBodies(p0, p1, p2, p3, toXa, toYa, toZa, wa);
    putBodies(q0, q1, q2, q3, toXb, toYb, toZb, wb);
    a += LANES << 2;
    b += LANES << 2;
  }
}
