// Gauss-Seidel sweeps of XPBD over what is no chain: the groups of rows, then the threads, each thread as a whole
// (strands.ts). Rows of a group share no movable body, so LANES of them are solved at once, with the same result as one
// after the other.
//
//   tension += gain (d - L) - softness tension        x_a += w_a n dtension        x_b -= w_b n dtension
//
// A cord's tension is never below zero. Ends closer than 1e-15 m have no direction between them: x is taken.
import { get, put } from '../memory/columns';
import { LANES, add, at, div, dot, mul, splat, sub } from '../memory/lanes';
import { NEAR, NEAR_ROOT, placeOf, signs, turned0, turned1, turned2, turned3 } from './packed-bodies';
import { orderLayers } from './passes';
import { areStretched, solveStrands } from './polyline-batches';
import { ConstraintTable, isCord, packedAt, part, putPart, tableAt, word } from './table';

// Turns that threads take beyond those asked for, at most, until they keep their lengths.
const AGAIN: i32 = 20;

// Sweeps so many times, from tensions of zero. To start from those of the last sub-step would be unstable: what is left
// of an error would be added up sub-step by sub-step.
export function sweepConstraints(table: usize, sweeps: i32): void {
  const t = tableAt(table);
  const first = t.groupsFirst;
  orderLayers(t);
  clear(t, (<i32>word(t.chains, t.chainCount) + 3) & ~3, first);
  clear(t, t.serialFirst, t.rowCount);
  for (let s = 0; s < sweeps; s++) {
    solveGroups(t, first, t.serialFirst, s == 0);
    for (let row = t.serialFirst; row < t.rowCount; row++) solveRow(t, row);
    solveStrands(t);
  }
  for (let turn = 0; turn < AGAIN && areStretched(t); turn++) solveStrands(t);
}

function clear(t: ConstraintTable, first: i32, last: i32): void {
  const size = sizeof<real>();
  if (last > first) memory.fill(t.tension + <usize>first * size, 0, <usize>(last - first) * size);
}

export function solveRow(t: ConstraintTable, row: i32): void {
  const gain = get(t.gain, row);
  if (gain == 0) return;
  const pa = packedAt(t, word(t.a, row));
  const pb = packedAt(t, word(t.b, row));
  const x = part(pb, 0) - part(pa, 0);
  const y = part(pb, 1) - part(pa, 1);
  const z = part(pb, 2) - part(pa, 2);
  const length = get(t.length, row);
  const tension = get(t.tension, row);
  let next = tension + gain * (sqrt<real>(x * x + y * y + z * z) - abs<real>(length)) - get(t.softness, row) * tension;
  if (isCord(length) && next < 0) next = 0;
  put(t.tension, row, next);
  pull(t, row, next - tension);
}

// Draws the ends of a row together.
function pull(t: ConstraintTable, row: i32, by: real): void {
  const pa = packedAt(t, word(t.a, row));
  const pb = packedAt(t, word(t.b, row));
  let x = part(pb, 0) - part(pa, 0);
  let y = part(pb, 1) - part(pa, 1);
  let z = part(pb, 2) - part(pa, 2);
  const square = x * x + y * y + z * z;
  let scale = by;
  if (square < NEAR) {
    x = 1;
    y = 0;
    z = 0;
  } else scale = by / sqrt<real>(square);
  const wa = part(pa, 3) * scale;
  const wb = part(pb, 3) * scale;
  putPart(pa, 0, part(pa, 0) + wa * x);
  putPart(pa, 1, part(pa, 1) + wa * y);
  putPart(pa, 2, part(pa, 2) + wa * z);
  putPart(pb, 0, part(pb, 0) - wb * x);
  putPart(pb, 1, part(pb, 1) - wb * y);
  putPart(pb, 2, part(pb, 2) - wb * z);
}

// @ts-ignore: decorator
@inline function putBodies(p0: usize, p1: usize, p2: usize, p3: usize, x: v128, y: v128, z: v128, w: v128): void {
  v128.store(p0, turned0(x, y, z, w));
  v128.store(p1, turned1(x, y, z, w));
  v128.store(p2, turned2(x, y, z, w));
  v128.store(p3, turned3(x, y, z, w));
}

// Groups of LANES rows that share no movable body. A fresh row's tension is zero, whatever is stored.
function solveGroups(t: ConstraintTable, first: i32, last: i32, fresh: bool): void {
  const packed = t.packed;
  const lengths = t.length;
  const gains = t.gain;
  const softnesses = t.softness;
  const tensions = t.tension;
  let a = t.a + ((<usize>first) << 2);
  let b = t.b + ((<usize>first) << 2);
  const end = at(last);
  for (let o = at(first); o < end; o += 16) {
    const p0 = placeOf(packed, a, 0);
    const p1 = placeOf(packed, a, 1);
    const p2 = placeOf(packed, a, 2);
    const p3 = placeOf(packed, a, 3);
    const q0 = placeOf(packed, b, 0);
    const q1 = placeOf(packed, b, 1);
    const q2 = placeOf(packed, b, 2);
    const q3 = placeOf(packed, b, 3);
    const a0 = v128.load(p0);
    const a1 = v128.load(p1);
    const a2 = v128.load(p2);
    const a3 = v128.load(p3);
    const b0 = v128.load(q0);
    const b1 = v128.load(q1);
    const b2 = v128.load(q2);
    const b3 = v128.load(q3);
    const xa = turned0(a0, a1, a2, a3);
    const ya = turned1(a0, a1, a2, a3);
    const za = turned2(a0, a1, a2, a3);
    const wa = turned3(a0, a1, a2, a3);
    const xb = turned0(b0, b1, b2, b3);
    const yb = turned1(b0, b1, b2, b3);
    const zb = turned2(b0, b1, b2, b3);
    const wb = turned3(b0, b1, b2, b3);
    let x = sub(xb, xa);
    let y = sub(yb, ya);
    let z = sub(zb, za);
    let square = dot(x, y, z, x, y, z);
    const near = v128.lt<real>(square, splat(NEAR));
    if (i32x4.bitmask(near) != 0) {
      x = v128.bitselect(splat(NEAR_ROOT), x, near);
      y = v128.andnot(y, near);
      z = v128.andnot(z, near);
      square = v128.bitselect(splat(NEAR), square, near);
    }
    const d = v128.sqrt<real>(square);
    const length = v128.load(lengths + o);
    const drawn = mul(v128.load(gains + o), sub(d, v128.abs<real>(length)));
    const tension = fresh ? splat(0) : v128.load(tensions + o);
    const wanted = fresh ? drawn : add(sub(tension, mul(v128.load(softnesses + o), tension)), drawn);
    const total = v128.andnot(wanted, signs(v128.and(wanted, length)));
    v128.store(tensions + o, total);
    const scale = div(fresh ? total : sub(total, tension), d);
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
