// One Gauss-Seidel sweep of XPBD over the coloured rows: rows of a colour share no movable body, so four of them are
// solved at once where reals are f32, with the same result as one after the other.
//
//   tension += gain (d - L) - softness tension        x_a += w_a n dtension        x_b -= w_b n dtension
//
// A cord's tension is never below zero. Ends closer than 1e-15 m have no direction between them: x is taken.
import { solveStrands } from './strands';
import { ConstraintTable, isCord, packedAt, part, putPart, tableAt, word } from './table';
import { get, put } from '../columns';

const NEAR: f32 = 1e-30;

// Sweeps so many times, from tensions of zero. To start from those of the last sub-step would be unstable: what is left
// of an error would be added up sub-step by sub-step.
export function sweepConstraints(table: usize, sweeps: i32): void {
  const t = tableAt(table);
  const first = t.coloursFirst;
  clear(t, (<i32>word(t.chains, t.chainCount) + 3) & ~3, t.rowCount);
  for (let s = 0; s < sweeps; s++) {
    if (sizeof<real>() == 4) solveLanes(t, first, t.serialFirst);
    else for (let row = first; row < t.serialFirst; row++) solveRow(t, row);
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

// @ts-ignore: decorator
@inline function bodyAt(t: ConstraintTable, column: usize, row: i32): usize {
  return t.packed + ((<usize>word(column, row)) << 4);
}

// @ts-ignore: decorator
@inline function lane(v: v128, i: i32): v128 {
  if (i == 0) return v128.shuffle<f32>(v, v, 0, 0, 0, 0);
  if (i == 1) return v128.shuffle<f32>(v, v, 1, 1, 1, 1);
  if (i == 2) return v128.shuffle<f32>(v, v, 2, 2, 2, 2);
  return v128.shuffle<f32>(v, v, 3, 3, 3, 3);
}

// Moves one end by its inverse mass, which stands in its fourth lane, times `scale` along `d`.
// @ts-ignore: decorator
@inline function towards(p: usize, body: v128, d: v128, scale: v128): void {
  v128.store(p, f32x4.add(body, f32x4.mul(d, f32x4.mul(scale, lane(body, 3)))));
}

// @ts-ignore: decorator
@inline function away(p: usize, body: v128, d: v128, scale: v128): void {
  v128.store(p, f32x4.sub(body, f32x4.mul(d, f32x4.mul(scale, lane(body, 3)))));
}

function solveLanes(t: ConstraintTable, first: i32, last: i32): void {
  const place = i32x4(-1, -1, -1, 0);
  const free = f32x4.splat(-3e38);
  for (let row = first; row < last; row += 4) {
    const o = (<usize>row) << 2;
    const a0 = bodyAt(t, t.a, row);
    const a1 = bodyAt(t, t.a, row + 1);
    const a2 = bodyAt(t, t.a, row + 2);
    const a3 = bodyAt(t, t.a, row + 3);
    const b0 = bodyAt(t, t.b, row);
    const b1 = bodyAt(t, t.b, row + 1);
    const b2 = bodyAt(t, t.b, row + 2);
    const b3 = bodyAt(t, t.b, row + 3);
    const A0 = v128.load(a0);
    const A1 = v128.load(a1);
    const A2 = v128.load(a2);
    const A3 = v128.load(a3);
    const B0 = v128.load(b0);
    const B1 = v128.load(b1);
    const B2 = v128.load(b2);
    const B3 = v128.load(b3);
    const D0 = v128.and(f32x4.sub(B0, A0), place);
    const D1 = v128.and(f32x4.sub(B1, A1), place);
    const D2 = v128.and(f32x4.sub(B2, A2), place);
    const D3 = v128.and(f32x4.sub(B3, A3), place);
    const xy01 = v128.shuffle<f32>(D0, D1, 0, 4, 1, 5);
    const xy23 = v128.shuffle<f32>(D2, D3, 0, 4, 1, 5);
    const x = v128.shuffle<f32>(xy01, xy23, 0, 1, 4, 5);
    const y = v128.shuffle<f32>(xy01, xy23, 2, 3, 6, 7);
    const z01 = v128.shuffle<f32>(D0, D1, 2, 6, 3, 7);
    const z23 = v128.shuffle<f32>(D2, D3, 2, 6, 3, 7);
    const z = v128.shuffle<f32>(z01, z23, 0, 1, 4, 5);
    const square = f32x4.add(f32x4.add(f32x4.mul(x, x), f32x4.mul(y, y)), f32x4.mul(z, z));
    if (v128.any_true(f32x4.lt(square, f32x4.splat(NEAR)))) {
      for (let i = row; i < row + 4; i++) solveRow(t, i);
      continue;
    }
    const d = f32x4.sqrt(square);
    const tension = v128.load(t.tension + o);
    const length = v128.load(t.length + o);
    const least = v128.andnot(free, i32x4.shr_s(length, 31));
    const drawn = f32x4.mul(v128.load(t.gain + o), f32x4.sub(d, f32x4.abs(length)));
    const kept = f32x4.sub(tension, f32x4.mul(v128.load(t.softness + o), tension));
    const next = f32x4.max(f32x4.add(kept, drawn), least);
    v128.store(t.tension + o, next);
    const by = f32x4.sub(next, tension);
    const scale = f32x4.div(by, d);
    const s0 = lane(scale, 0);
    const s1 = lane(scale, 1);
    const s2 = lane(scale, 2);
    const s3 = lane(scale, 3);
    towards(a0, A0, D0, s0);
    towards(a1, A1, D1, s1);
    towards(a2, A2, D2, s2);
    towards(a3, A3, D3, s3);
    away(b0, B0, D0, s0);
    away(b1, B1, D1, s1);
    away(b2, B2, D2, s2);
    away(b3, B3, D3, s3);
  }
}
