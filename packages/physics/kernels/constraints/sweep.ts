// Gauss-Seidel sweeps of XPBD over what is no chain: the coloured rows, then the threads, each thread as a whole
// (strands.ts). Rows of a colour share no movable body, so LANES of them are solved at once, with the same result as one
// after the other.
//
//   tension += gain (d - L) - softness tension        x_a += w_a n dtension        x_b -= w_b n dtension
//
// A cord's tension is never below zero. Ends closer than 1e-15 m have no direction between them: x is taken.
import { get, put } from '../columns';
import { LANES, add, at, div, dot, larger, mul, splat, sub } from '../lanes';
import { RUNS, WOVEN, cords, drop, firsts, pick, seconds } from './lanes';
import { orderLayers } from './layers';
import { solveStrands } from './strands';
import { ConstraintTable, isCord, packedAt, part, putPart, stride, tableAt, word } from './table';

const NEAR: f32 = 1e-30;

// Sweeps so many times, from tensions of zero. To start from those of the last sub-step would be unstable: what is left
// of an error would be added up sub-step by sub-step.
export function sweepConstraints(table: usize, sweeps: i32): void {
  const t = tableAt(table);
  const first = t.coloursFirst;
  orderLayers(t);
  clear(t, (<i32>word(t.chains, t.chainCount) + 3) & ~3, first);
  clear(t, t.serialFirst, t.rowCount);
  for (let s = 0; s < sweeps; s++) {
    if (s == 0) solveLanes(t, first, t.serialFirst, true);
    else solveLanes(t, first, t.serialFirst, false);
    for (let row = t.serialFirst; row < t.rowCount; row++) solveRow(t, row);
    solveStrands(t);
  }
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
  if (square < <real>NEAR) {
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

// Where bodies that do not follow each other are brought together: x, y, z and inverse mass of both ends.
const PLACE: usize = memory.data(128, 16);

// Rows of a multiple of LANES. Where the bodies of LANES rows follow each other, as in a cloth, they are vectors as they
// stand. A fresh row's tension is zero, whatever is stored.
// @ts-ignore: decorator
@inline function solveLanes(t: ConstraintTable, first: i32, last: i32, fresh: bool): void {
  const free = splat(<real>-3e38);
  const packed = t.packed;
  const apart = stride;
  const lengths = t.length;
  const gains = t.gain;
  const softnesses = t.softness;
  const tensions = t.tension;
  const as = t.a;
  const bs = t.b;
  const kinds = t.kinds;
  for (let row = first; row < last; row += LANES) {
    const o = at(row);
    const a = as + ((<usize>row) << 2);
    const b = bs + ((<usize>row) << 2);
    const kind = word(kinds, row / LANES);
    let p = PLACE;
    let q = PLACE + 64;
    let next = <usize>16;
    if (kind == RUNS) {
      p = packed + at(load<u32>(a));
      q = packed + at(load<u32>(b));
      next = apart;
    } else bring(packed, apart, a, b, kind);
    const xa = v128.load(p);
    const ya = v128.load(p + next);
    const za = v128.load(p + next * 2);
    const xb = v128.load(q);
    const yb = v128.load(q + next);
    const zb = v128.load(q + next * 2);
    const x = sub(xb, xa);
    const y = sub(yb, ya);
    const z = sub(zb, za);
    const square = dot(x, y, z, x, y, z);
    const d = v128.sqrt<real>(square);
    const length = v128.load(lengths + o);
    const least = v128.andnot(free, cords(length));
    const drawn = mul(v128.load(gains + o), sub(d, v128.abs<real>(length)));
    const tension = fresh ? splat(0) : v128.load(tensions + o);
    const kept = fresh ? drawn : add(sub(tension, mul(v128.load(softnesses + o), tension)), drawn);
    if (v128.any_true(v128.lt<real>(square, splat(<real>NEAR)))) {
      if (fresh) v128.store(tensions + o, splat(0));
      for (let i = row; i < row + LANES; i++) solveRow(t, i);
      continue;
    }
    const total = larger(kept, least);
    v128.store(tensions + o, total);
    const scale = div(fresh ? total : sub(total, tension), d);
    const wa = mul(v128.load(p + next * 3), scale);
    const wb = mul(v128.load(q + next * 3), scale);
    const toXa = add(xa, mul(wa, x));
    const toYa = add(ya, mul(wa, y));
    const toZa = add(za, mul(wa, z));
    const toXb = sub(xb, mul(wb, x));
    const toYb = sub(yb, mul(wb, y));
    const toZb = sub(zb, mul(wb, z));
    v128.store(p, toXa);
    v128.store(p + next, toYa);
    v128.store(p + next * 2, toZa);
    v128.store(q, toXb);
    v128.store(q + next, toYb);
    v128.store(q + next * 2, toZb);
    if (kind != RUNS) takeBack(packed, apart, a, b, kind);
  }
}

// @ts-ignore: decorator
@inline function bring(packed: usize, apart: usize, a: usize, b: usize, kind: u32): void {
  let column = packed;
  const first = at(load<u32>(a));
  for (let i: usize = 0; i < 64; i += 16) {
    if (kind == WOVEN) {
      const v = v128.load(column + first);
      const w = v128.load(column + first, 16);
      v128.store(PLACE + i, firsts(v, w));
      v128.store(PLACE + i, seconds(v, w), 64);
    } else {
      v128.store(PLACE + i, pick(column, a));
      v128.store(PLACE + i, pick(column, b), 64);
    }
    column += apart;
  }
}

// @ts-ignore: decorator
@inline function takeBack(packed: usize, apart: usize, a: usize, b: usize, kind: u32): void {
  let column = packed;
  const first = at(load<u32>(a));
  for (let i: usize = 0; i < 48; i += 16) {
    const v = v128.load(PLACE + i);
    const w = v128.load(PLACE + i, 64);
    if (kind == WOVEN) {
      v128.store(column + first, firsts(v, w));
      v128.store(column + first, seconds(v, w), 16);
    } else {
      drop(column, a, v);
      drop(column, b, w);
    }
    column += apart;
  }
}
