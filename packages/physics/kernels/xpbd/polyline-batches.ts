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
import { LANES, add, at, div, dot, larger, mul, splat, sub } from '../memory/lanes';
import { NEAR, NEAR_ROOT, placeOf, signs, turned0, turned1, turned2, turned3 } from './packed-bodies';
import { ConstraintTable, LAYERS, word } from './table';

// What solving keeps of a body of each thread, and of the row from it to the next body.
@unmanaged
class Knot {
  x: v128;
  y: v128;
  z: v128;
  inverse: v128;
  // r.
  rx: v128;
  ry: v128;
  rz: v128;
  // 1 / d.
  per: v128;
  // Natural length plus e times tension.
  rest: v128;
  // Share that the row before has of this one's unknown, and the known side, both by the pivot.
  upper: v128;
  known: v128;
  // Impulse over d.
  pull: v128;
}

const KNOT: usize = 192;

// A pull by which a thread counts as taut: D w over its length; at 2/3 it would be unstable along n.
const TAUT: real = 0.5;
// Least pivot over the diagonal: a straight thread between two anchors is held twice.
const LEAST_PIVOT: real = sizeof<real>() == 4 ? 1e-4 : 1e-10;
// Least length at the end that is divided by, over that at the start.
const LEAST_END: real = 0.001;
const ALL = i32x4.splat(-1);

// Of twice its length: an error of one in a thousand.
const ROUGH: real = 2e-3;
// The same, of one in 250.
const STRETCHED: real = 8e-3;

// @ts-ignore: decorator
@inline function firstKnot(t: ConstraintTable): Knot {
  return changetype<Knot>(t.work + KNOT);
}

// That of the last bodies, which no row follows.
// @ts-ignore: decorator
@inline function lastKnot(t: ConstraintTable, first: i32, last: i32): Knot {
  return changetype<Knot>(t.work + <usize>((last - first) / LANES + 1) * KNOT);
}

// @ts-ignore: decorator
@inline function after(knot: Knot): Knot {
  return changetype<Knot>(changetype<usize>(knot) + KNOT);
}

// @ts-ignore: decorator
@inline function before(knot: Knot): Knot {
  return changetype<Knot>(changetype<usize>(knot) - KNOT);
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
      const rough = solve(t, first, last, ALL);
      // Turning changes lengths by second order: once more where that is much.
      if (v128.any_true(rough)) solve(t, first, last, rough);
    }
  }
}

// Whether any row is off its length by more than that after all were solved: threads that cross and bear what hangs from
// each other take turns, and undo each other's work. Those of the layer solved last are as they should be.
export function areStretched(t: ConstraintTable): bool {
  for (let i = 0; i < t.layerCount - 1; i++) {
    const layer = <i32>word(t.layers, LAYERS + 1 + i);
    const end = <i32>word(t.layers, layer + 1);
    for (let strand = <i32>word(t.layers, layer); strand < end; strand++) {
      if (isStretched(t, word(t.strands, strand), word(t.strands, strand + 1))) return true;
    }
  }
  return false;
}

function isStretched(t: ConstraintTable, first: i32, last: i32): bool {
  const packed = t.packed;
  const a = t.a + ((<usize>first) << 2);
  let b = t.b + ((<usize>first) << 2);
  let a0 = v128.load(placeOf(packed, a, 0));
  let a1 = v128.load(placeOf(packed, a, 1));
  let a2 = v128.load(placeOf(packed, a, 2));
  let a3 = v128.load(placeOf(packed, a, 3));
  let stretched = splat(0);
  const end = at(last);
  for (let o = at(first); o < end; o += 16) {
    const b0 = v128.load(placeOf(packed, b, 0));
    const b1 = v128.load(placeOf(packed, b, 1));
    const b2 = v128.load(placeOf(packed, b, 2));
    const b3 = v128.load(placeOf(packed, b, 3));
    const r0 = sub(b0, a0);
    const r1 = sub(b1, a1);
    const r2 = sub(b2, a2);
    const r3 = sub(b3, a3);
    const x = turned0(r0, r1, r2, r3);
    const y = turned1(r0, r1, r2, r3);
    const z = turned2(r0, r1, r2, r3);
    const length = v128.load(t.length + o);
    const rest = add(v128.abs<real>(length), mul(v128.load(t.softness + o), v128.load(t.tension + o)));
    const wanted = mul(rest, rest);
    const error = sub(dot(x, y, z, x, y, z), wanted);
    // A cord may be shorter than it is long.
    const counts = v128.andnot(v128.lt<real>(v128.load(t.gain + o), splat(Infinity)), signs(v128.and(error, length)));
    const isOff = v128.gt<real>(v128.abs<real>(error), mul(splat(STRETCHED), wanted));
    stretched = v128.or(stretched, v128.and(isOff, counts));
    a0 = b0;
    a1 = b1;
    a2 = b2;
    a3 = b3;
    b += LANES << 2;
  }
  return v128.any_true(stretched);
}

// Solves those threads of a strand whose lanes are set. Returns which of them turned so far that their lengths are rough.
function solve(t: ConstraintTable, first: i32, last: i32, who: v128): v128 {
  eliminate(t, first, last);
  const taut = substitute(t, first, last, who);
  if (v128.any_true(taut)) return turn(t, first, last, taut);
  shift(t, first, last);
  return taut;
}

// Reads a body of each thread.
// @ts-ignore: decorator
@inline function gather(packed: usize, ids: usize, knot: Knot): void {
  const a = v128.load(placeOf(packed, ids, 0));
  const b = v128.load(placeOf(packed, ids, 1));
  const c = v128.load(placeOf(packed, ids, 2));
  const d = v128.load(placeOf(packed, ids, 3));
  knot.x = turned0(a, b, c, d);
  knot.y = turned1(a, b, c, d);
  knot.z = turned2(a, b, c, d);
  knot.inverse = turned3(a, b, c, d);
}

// Writes a body of each thread.
// @ts-ignore: decorator
@inline function scatter(packed: usize, ids: usize, x: v128, y: v128, z: v128, inverse: v128): void {
  v128.store(placeOf(packed, ids, 0), turned0(x, y, z, inverse));
  v128.store(placeOf(packed, ids, 1), turned1(x, y, z, inverse));
  v128.store(placeOf(packed, ids, 2), turned2(x, y, z, inverse));
  v128.store(placeOf(packed, ids, 3), turned3(x, y, z, inverse));
}

// From the first row to the last.
function eliminate(t: ConstraintTable, first: i32, last: i32): void {
  const zero = splat(0);
  const diagonals = t.gain;
  const flexibilities = t.softness;
  const lengths = t.length;
  const tensions = t.tension;
  const packed = t.packed;
  const end = at(last);
  let ids = t.b + ((<usize>first) << 2);
  let knot = firstKnot(t);
  gather(packed, t.a + ((<usize>first) << 2), knot);
  let nx = zero;
  let ny = zero;
  let nz = zero;
  let pivotBefore = zero;
  let knownBefore = zero;
  for (let o = at(first); o < end; o += 16) {
    const below = after(knot);
    gather(packed, ids, below);
    ids += LANES << 2;
    let rx = sub(below.x, knot.x);
    let ry = sub(below.y, knot.y);
    let rz = sub(below.z, knot.z);
    let square = dot(rx, ry, rz, rx, ry, rz);
    const near = v128.lt<real>(square, splat(NEAR));
    if (i32x4.bitmask(near) != 0) {
      rx = v128.bitselect(splat(NEAR_ROOT), rx, near);
      ry = v128.andnot(ry, near);
      rz = v128.andnot(rz, near);
      square = v128.bitselect(splat(NEAR), square, near);
    }
    const d = v128.sqrt<real>(square);
    const per = div(splat(1), d);
    const mx = mul(rx, per);
    const my = mul(ry, per);
    const mz = mul(rz, per);
    const length = v128.load(lengths + o);
    const tension = v128.load(tensions + o);
    const rest = add(v128.abs<real>(length), mul(v128.load(flexibilities + o), tension));
    const error = sub(d, rest);
    const loose = v128.and(v128.le<real>(error, zero), v128.le<real>(tension, zero));
    const slack = v128.and(loose, signs(length));
    const diagonal = v128.bitselect(splat(Infinity), v128.load(diagonals + o), slack);
    const lower = mul(knot.inverse, dot(mx, my, mz, nx, ny, nz));
    knot.upper = mul(lower, pivotBefore);
    // What each row waits for: the square first, so that the pivot before it comes in as late as can be.
    const taken = mul(mul(lower, lower), pivotBefore);
    const pivot = larger(sub(diagonal, taken), mul(splat(LEAST_PIVOT), diagonal));
    pivotBefore = div(splat(1), pivot);
    knownBefore = mul(add(error, mul(lower, knownBefore)), pivotBefore);
    knot.rx = rx;
    knot.ry = ry;
    knot.rz = rz;
    knot.per = per;
    knot.rest = rest;
    knot.known = knownBefore;
    nx = mx;
    ny = my;
    nz = mz;
    knot = below;
  }
}

// From the last row to the first: finds the impulses. Returns which threads are taut.
function substitute(t: ConstraintTable, first: i32, last: i32, who: v128): v128 {
  const flexibilities = t.softness;
  const lengths = t.length;
  const tensions = t.tension;
  const start = at(first);
  let knot = lastKnot(t, first, last);
  let inverseBelow = knot.inverse;
  // Of the row below: its unknown, and the share that the row above has of it.
  let below = splat(0);
  let upper = splat(0);
  let taut = splat(0);
  for (let o = at(last); o > start; ) {
    o -= 16;
    knot = before(knot);
    below = add(knot.known, mul(upper, below));
    upper = knot.upper;
    const tension = v128.load(tensions + o);
    const wanted = add(tension, below);
    const pushes = signs(v128.and(wanted, v128.load(lengths + o)));
    const total = v128.bitselect(v128.andnot(wanted, pushes), tension, who);
    v128.store(tensions + o, total);
    const by = sub(total, tension);
    const rest = add(knot.rest, mul(v128.load(flexibilities + o), by));
    knot.pull = mul(by, knot.per);
    knot.rest = rest;
    const across = mul(by, add(knot.inverse, inverseBelow));
    taut = v128.or(taut, v128.gt<real>(across, mul(splat(TAUT), rest)));
    inverseBelow = knot.inverse;
  }
  return taut;
}

// Moves the bodies by impulses along n.
function shift(t: ConstraintTable, first: i32, last: i32): void {
  const packed = t.packed;
  const end = lastKnot(t, first, last);
  let ids = t.a + ((<usize>first) << 2);
  let fx = splat(0);
  let fy = splat(0);
  let fz = splat(0);
  let knot = firstKnot(t);
  for (; knot != end; knot = after(knot)) {
    const w = knot.inverse;
    const x = mul(knot.pull, knot.rx);
    const y = mul(knot.pull, knot.ry);
    const z = mul(knot.pull, knot.rz);
    const toX = add(knot.x, mul(w, sub(x, fx)));
    const toY = add(knot.y, mul(w, sub(y, fy)));
    const toZ = add(knot.z, mul(w, sub(z, fz)));
    scatter(packed, ids, toX, toY, toZ, w);
    ids += LANES << 2;
    fx = x;
    fy = y;
    fz = z;
  }
  const w = knot.inverse;
  const lastIds = t.b + ((<usize>(last - LANES)) << 2);
  scatter(packed, lastIds, sub(knot.x, mul(w, fx)), sub(knot.y, mul(w, fy)), sub(knot.z, mul(w, fz)), w);
}

// Moves the bodies by impulses that turn with them, where threads are taut. Returns the taut ones whose lengths are rough.
function turn(t: ConstraintTable, first: i32, last: i32, taut: v128): v128 {
  const zero = splat(0);
  const one = splat(1);
  const end = lastKnot(t, first, last);
  let knot = firstKnot(t);
  let fx = zero;
  let fy = zero;
  let fz = zero;
  let sx = zero;
  let sy = zero;
  let sz = zero;
  let above = zero;
  let share = zero;
  for (; knot != end; knot = after(knot)) {
    const w = knot.inverse;
    const pulls = v128.and(taut, v128.gt<real>(knot.pull, zero));
    const g = v128.and(div(knot.pull, larger(mul(knot.rest, knot.per), splat(LEAST_END))), pulls);
    const pull = v128.bitselect(g, knot.pull, pulls);
    const x = mul(pull, knot.rx);
    const y = mul(pull, knot.ry);
    const z = mul(pull, knot.rz);
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
  const from = mul(knot.inverse, above);
  const per = div(one, sub(add(one, from), mul(from, share)));
  sx = mul(sub(mul(from, sx), mul(knot.inverse, fx)), per);
  sy = mul(sub(mul(from, sy), mul(knot.inverse, fy)), per);
  sz = mul(sub(mul(from, sz), mul(knot.inverse, fz)), per);
  return v128.and(turnBack(t, first, last, sx, sy, sz), taut);
}

// From the last body, which is moved by s, to the first.
// @ts-ignore: decorator
@inline function turnBack(t: ConstraintTable, first: i32, last: i32, endX: v128, endY: v128, endZ: v128): v128 {
  const packed = t.packed;
  const start = firstKnot(t);
  let ids = t.a + ((<usize>last) << 2);
  let knot = lastKnot(t, first, last);
  let sx = endX;
  let sy = endY;
  let sz = endZ;
  let x = add(knot.x, sx);
  let y = add(knot.y, sy);
  let z = add(knot.z, sz);
  scatter(packed, t.b + ((<usize>(last - LANES)) << 2), x, y, z, knot.inverse);
  let rough = splat(0);
  while (knot != start) {
    knot = before(knot);
    sx = add(knot.rx, mul(knot.upper, sx));
    sy = add(knot.ry, mul(knot.upper, sy));
    sz = add(knot.rz, mul(knot.upper, sz));
    const toX = add(knot.x, sx);
    const toY = add(knot.y, sy);
    const toZ = add(knot.z, sz);
    ids -= LANES << 2;
    scatter(packed, ids, toX, toY, toZ, knot.inverse);
    const rx = sub(x, toX);
    const ry = sub(y, toY);
    const rz = sub(z, toZ);
    const wanted = mul(knot.rest, knot.rest);
    const error = v128.abs<real>(sub(dot(rx, ry, rz, rx, ry, rz), wanted));
    const isRough = v128.gt<real>(error, mul(splat(ROUGH), wanted));
    rough = v128.or(rough, v128.and(isRough, v128.ne<real>(knot.pull, splat(0))));
    x = toX;
    y = toY;
    z = toZ;
  }
  return rough;
}
