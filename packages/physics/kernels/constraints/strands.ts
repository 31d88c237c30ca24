// Strands: LANES threads solved side by side, each directly. Newton's step for all rows of a thread together, whose
// matrix has three diagonals, as in chain.ts; a thread's pull reaches from end to end at once, however long it is.
//
// For row j between bodies j and j + 1, unit vector n_j, flexibility e = 1 / (k h^2), sum of inverse masses w:
//
//   (w + e) D_j - w_j (n_j.n_j-1) D_j-1 - w_j+1 (n_j.n_j+1) D_j+1 = C_j - e tension_j
//
// A slack thread moves by its impulses along n. A taut one would vibrate across: the impulses turn with it while it moves,
// and the directions at the end of the sub-step are what backward Euler asks for. With g = D / (length at the end) these
// are again three diagonals, the same for x, y and z:
//
//   (1 + w_j (g_j-1 + g_j)) s_j - w_j g_j-1 s_j-1 - w_j g_j s_j+1 = w_j (g_j r_j - g_j-1 r_j-1)
//
// with s_j the way body j is moved and r_j the vector from it to the next. That takes no less than was there: sums of
// positive numbers only, stable for any pull. Rows that push (D < 0) act along n. Both conserve momentum.
//
// Sources: Han, Harada: Tridiagonal matrix formulation for inextensible hair strand simulation (VRIPHYS 2013); for why a
// pull must turn: Tournier et al.: Stable constrained dynamics (SIGGRAPH 2015). Cost: three divisions and a square root
// a row, twice that for a taut one.
import { LANES, add, at, div, mul, splat, sub } from '../lanes';
import { cords, drop, isRun, pick } from './lanes';
import { ConstraintTable, LAYERS, stride, word } from './table';

// What solving keeps of a body of each thread, and of the row from it to the next body.
@unmanaged
class Knot {
  x: v128;
  y: v128;
  z: v128;
  inverse: v128;
  // r and its length.
  rx: v128;
  ry: v128;
  rz: v128;
  d: v128;
  // e, and natural length plus e times tension.
  flexibility: v128;
  rest: v128;
  // Share of the next row's unknown, and the known side, both by the pivot.
  upper: v128;
  known: v128;
  // Impulse over d.
  pull: v128;
}

const KNOT: usize = 208;

// A pull by which a thread counts as taut: D w over its length; at 2/3 it would be unstable along n.
const TAUT: real = 0.5;
// Least pivot over the diagonal: a straight thread between two anchors is held twice.
const LEAST_PIVOT: real = sizeof<real>() == 4 ? 1e-4 : 1e-10;
const ALL = i32x4.splat(-1);
const NEAR: real = 1e-30;
const NEAR_ROOT: real = 1e-15;

// @ts-ignore: decorator
@inline function knotAt(t: ConstraintTable, index: i32): Knot {
  return changetype<Knot>(t.work + <usize>index * KNOT);
}

// Solves each strand, layer by layer: what pulls hardest first. What comes later moves the nodes across it, which changes
// its length by second order only; the other way round its pull would move what does not pull, by first order.
export function solveStrands(t: ConstraintTable): void {
  for (let i = 0; i < t.layerCount; i++) {
    const layer = <i32>word(t.layers, LAYERS + 1 + i);
    const end = <i32>word(t.layers, layer + 1);
    for (let strand = <i32>word(t.layers, layer); strand < end; strand++) {
      const first = <i32>word(t.strands, strand);
      const last = <i32>word(t.strands, strand + 1);
      const taut = solve(t, first, last, ALL);
      // Turning changes lengths by second order: once more for that.
      if (v128.any_true(taut)) solve(t, first, last, taut);
    }
  }
}

// Solves those threads of a strand whose lanes are set. Returns which of them were taut, and turned.
function solve(t: ConstraintTable, first: i32, last: i32, who: v128): v128 {
  eliminate(t, first, last);
  const taut = substitute(t, first, last, who);
  if (v128.any_true(taut)) turn(t, first, last, taut);
  else shift(t, first, last);
  return taut;
}

// Reads a body of each thread.
// @ts-ignore: decorator
@inline function gather(t: ConstraintTable, column: usize, row: i32, knot: Knot): void {
  const ids = column + ((<usize>row) << 2);
  const X = t.packed;
  if (isRun(ids)) {
    const p = X + at(load<u32>(ids));
    knot.x = v128.load(p);
    knot.y = v128.load(p + stride);
    knot.z = v128.load(p + stride * 2);
    knot.inverse = v128.load(p + stride * 3);
    return;
  }
  knot.x = pick(X, ids);
  knot.y = pick(X + stride, ids);
  knot.z = pick(X + stride * 2, ids);
  knot.inverse = pick(X + stride * 3, ids);
}

// Writes a body of each thread, moved by s.
// @ts-ignore: decorator
@inline function scatter(
  t: ConstraintTable,
  column: usize,
  row: i32,
  knot: Knot,
  sx: v128,
  sy: v128,
  sz: v128,
): void {
  const ids = column + ((<usize>row) << 2);
  const x = add(knot.x, sx);
  const y = add(knot.y, sy);
  const z = add(knot.z, sz);
  const X = t.packed;
  if (isRun(ids)) {
    const p = X + at(load<u32>(ids));
    v128.store(p, x);
    v128.store(p + stride, y);
    v128.store(p + stride * 2, z);
    return;
  }
  drop(X, ids, x);
  drop(X + stride, ids, y);
  drop(X + stride * 2, ids, z);
}

// From the first row to the last.
function eliminate(t: ConstraintTable, first: i32, last: i32): void {
  const zero = splat(0);
  const one = splat(1);
  let index = 0;
  let knot = knotAt(t, 0);
  gather(t, t.a, first, knot);
  let nx = zero;
  let ny = zero;
  let nz = zero;
  let pivotBefore = zero;
  let knownBefore = zero;
  let activeBefore = zero;
  for (let row = first; row < last; row += LANES) {
    const next = knotAt(t, ++index);
    gather(t, t.b, row, next);
    let rx = sub(next.x, knot.x);
    let ry = sub(next.y, knot.y);
    let rz = sub(next.z, knot.z);
    let square = add(add(mul(rx, rx), mul(ry, ry)), mul(rz, rz));
    const near = v128.lt<real>(square, splat(NEAR));
    if (v128.any_true(near)) {
      rx = v128.bitselect(splat(NEAR_ROOT), rx, near);
      ry = v128.andnot(ry, near);
      rz = v128.andnot(rz, near);
      square = v128.bitselect(splat(NEAR), square, near);
    }
    const d = v128.sqrt<real>(square);
    const per = div(one, d);
    const mx = mul(rx, per);
    const my = mul(ry, per);
    const mz = mul(rz, per);
    const gain = v128.load(t.gain + at(row));
    const length = v128.load(t.length + at(row));
    const tension = v128.load(t.tension + at(row));
    const weighs = v128.gt<real>(gain, zero);
    const diagonal = v128.bitselect(div(one, gain), one, weighs);
    const flexibility = mul(v128.load(t.softness + at(row)), diagonal);
    const rest = add(v128.abs<real>(length), mul(flexibility, tension));
    const error = sub(d, rest);
    const loose = v128.and(v128.le<real>(error, zero), v128.le<real>(tension, zero));
    const active = v128.andnot(weighs, v128.and(loose, cords(length)));
    const cosine = add(add(mul(mx, nx), mul(my, ny)), mul(mz, nz));
    const lower = v128.and(mul(knot.inverse, cosine), v128.and(active, activeBefore));
    if (row > first) knotAt(t, index - 2).upper = mul(lower, pivotBefore);
    // What each row waits for: the square first, so that the pivot before it comes in as late as can be.
    const taken = mul(mul(lower, lower), pivotBefore);
    const pivot = v128.max<real>(sub(diagonal, taken), mul(splat(LEAST_PIVOT), diagonal));
    pivotBefore = div(one, pivot);
    knownBefore = v128.and(mul(add(error, mul(lower, knownBefore)), pivotBefore), active);
    activeBefore = active;
    knot.rx = rx;
    knot.ry = ry;
    knot.rz = rz;
    knot.d = d;
    knot.flexibility = flexibility;
    knot.rest = rest;
    knot.upper = zero;
    knot.known = knownBefore;
    nx = mx;
    ny = my;
    nz = mz;
    knot = next;
  }
}

// From the last row to the first: finds the impulses. Returns which threads are taut.
function substitute(t: ConstraintTable, first: i32, last: i32, who: v128): v128 {
  const free = splat(<real>-3e38);
  let index = (last - first) / LANES;
  let below = knotAt(t, index).inverse;
  let next = splat(0);
  let taut = splat(0);
  for (let row = last - LANES; row >= first; row -= LANES) {
    const knot = knotAt(t, --index);
    next = add(knot.known, mul(knot.upper, next));
    const tension = v128.load(t.tension + at(row));
    const least = v128.andnot(free, cords(v128.load(t.length + at(row))));
    const total = v128.bitselect(v128.max<real>(add(tension, next), least), tension, who);
    v128.store(t.tension + at(row), total);
    const by = sub(total, tension);
    knot.pull = div(by, knot.d);
    knot.rest = add(knot.rest, mul(knot.flexibility, by));
    const across = mul(by, add(knot.inverse, below));
    taut = v128.or(taut, v128.gt<real>(across, mul(splat(TAUT), knot.rest)));
    below = knot.inverse;
  }
  return taut;
}

// Moves the bodies by impulses along n.
function shift(t: ConstraintTable, first: i32, last: i32): void {
  let fx = splat(0);
  let fy = splat(0);
  let fz = splat(0);
  let index = 0;
  for (let row = first; row < last; row += LANES) {
    const knot = knotAt(t, index++);
    const w = knot.inverse;
    const x = mul(knot.pull, knot.rx);
    const y = mul(knot.pull, knot.ry);
    const z = mul(knot.pull, knot.rz);
    scatter(t, t.a, row, knot, mul(w, sub(x, fx)), mul(w, sub(y, fy)), mul(w, sub(z, fz)));
    fx = x;
    fy = y;
    fz = z;
  }
  const knot = knotAt(t, index);
  const w = v128.neg<real>(knot.inverse);
  scatter(t, t.b, last - LANES, knot, mul(w, fx), mul(w, fy), mul(w, fz));
}

// Moves the bodies by impulses that turn with them, where threads are taut. From the first body to the last, and back.
function turn(t: ConstraintTable, first: i32, last: i32, taut: v128): void {
  const zero = splat(0);
  const one = splat(1);
  const count = (last - first) / LANES;
  let fx = zero;
  let fy = zero;
  let fz = zero;
  let sx = zero;
  let sy = zero;
  let sz = zero;
  let above = zero;
  let share = zero;
  for (let index = 0; index <= count; index++) {
    const knot = knotAt(t, index);
    const w = knot.inverse;
    let g = zero;
    let x = zero;
    let y = zero;
    let z = zero;
    if (index < count) {
      const pulls = v128.and(taut, v128.gt<real>(knot.pull, zero));
      const end = v128.max<real>(knot.rest, mul(knot.d, splat(<real>0.001)));
      g = v128.and(div(mul(knot.pull, knot.d), end), pulls);
      const pull = v128.bitselect(g, knot.pull, pulls);
      x = mul(pull, knot.rx);
      y = mul(pull, knot.ry);
      z = mul(pull, knot.rz);
    }
    const from = mul(w, above);
    const per = div(one, sub(add(add(one, from), mul(w, g)), mul(from, share)));
    sx = mul(add(mul(w, sub(x, fx)), mul(from, sx)), per);
    sy = mul(add(mul(w, sub(y, fy)), mul(from, sy)), per);
    sz = mul(add(mul(w, sub(z, fz)), mul(from, sz)), per);
    share = mul(mul(w, g), per);
    above = g;
    fx = x;
    fy = y;
    fz = z;
    knot.upper = share;
    knot.rx = sx;
    knot.ry = sy;
    knot.rz = sz;
  }
  scatter(t, t.b, last - LANES, knotAt(t, count), sx, sy, sz);
  for (let index = count - 1; index >= 0; index--) {
    const knot = knotAt(t, index);
    sx = add(knot.rx, mul(knot.upper, sx));
    sy = add(knot.ry, mul(knot.upper, sy));
    sz = add(knot.rz, mul(knot.upper, sz));
    scatter(t, t.a, first + LANES * index, knot, sx, sy, sz);
  }
}
