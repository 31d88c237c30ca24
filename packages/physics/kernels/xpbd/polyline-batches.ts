// Batches of LANES polylines, each solved directly in its SIMD lane: a Newton step for all rows of a polyline at
// once, whose matrix is tridiagonal, as in chain.ts. A tension acts from end to end at once, however long the
// polyline.
//
// For row j between bodies j and j + 1, unit vector n_j, compliance e = 1 / (k h^2), sum of inverse masses w:
//
//   (w + e) D_j - w_j (n_j.n_j-1) D_j-1 - w_j+1 (n_j.n_j+1) D_j+1 = C_j - e tension_j
//
// In a slack polyline the impulses act along n. A taut one would vibrate transversely, so there the impulses turn
// with the rows, and act along the directions at the end of the sub-step, as backward Euler requires. With g = D /
// (length at the end) the equations are again tridiagonal, with one matrix for x, y and z:
//
//   (1 + w_j (g_j-1 + g_j)) s_j - w_j g_j-1 s_j-1 - w_j g_j s_j+1 = w_j (g_j r_j - g_j-1 r_j-1)
//
// where s_j is the displacement of body j and r_j the vector from it to the next. The matrix is a sum of positive
// terms, so it is stable at any tension. Rows under compression (D < 0) act along n. Both variants conserve momentum.
//
// Sources: Han, Harada: Tridiagonal matrix formulation for inextensible hair strand simulation (VRIPHYS 2013); for
// the turning directions: Tournier et al.: Stable constrained dynamics (SIGGRAPH 2015). Cost: three divisions and a
// square root per row, twice as much if taut.
import { LANES, add, at, div, dot, larger, mul, splat, sub } from '../memory/lanes';
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
import { ConstraintTable, MAX_PASSES, word } from './table';

// The state of a body of each polyline, and of the row from it to the next body.
@unmanaged
class PolylineNode {
  x: v128;
  y: v128;
  z: v128;
  inverseMass: v128;
  // The vector r to the next body, and 1 / |r|.
  rx: v128;
  ry: v128;
  rz: v128;
  inverseLength: v128;
  // Natural length plus compliance times tension.
  restLength: v128;
  // Coefficient of this unknown in the previous row, and right-hand side, both divided by the pivot.
  upper: v128;
  rhs: v128;
  // Impulse divided by d.
  impulseOverLength: v128;
}

const NODE_BYTES: usize = 192;

// The ratio D w / length above which a polyline is taut; impulses along n are unstable at 2/3.
const TAUT_RATIO: real = 0.5;
// Minimum pivot over the diagonal: a straight polyline between two anchors is overdetermined.
const MIN_PIVOT: real = sizeof<real>() == 4 ? 1e-4 : 1e-10;
// Minimum divisor: length at the end over length at the start.
const MIN_END_LENGTH: real = 0.001;
const ALL_LANES = i32x4.splat(-1);

// Tolerances of the squared length: length errors of 0.1 % for a second solve of a batch, of 0.4 % for an iteration.
const SOLVE_TOLERANCE: real = 2e-3;
const ITERATION_TOLERANCE: real = 8e-3;

// @ts-ignore: decorator
@inline function firstNode(t: ConstraintTable): PolylineNode {
  return changetype<PolylineNode>(t.scratch + NODE_BYTES);
}

// Returns the node of the last bodies, which no row follows.
// @ts-ignore: decorator
@inline function lastNode(t: ConstraintTable, first: i32, last: i32): PolylineNode {
  return changetype<PolylineNode>(t.scratch + <usize>((last - first) / LANES + 1) * NODE_BYTES);
}

// @ts-ignore: decorator
@inline function after(node: PolylineNode): PolylineNode {
  return changetype<PolylineNode>(changetype<usize>(node) + NODE_BYTES);
}

// @ts-ignore: decorator
@inline function before(node: PolylineNode): PolylineNode {
  return changetype<PolylineNode>(changetype<usize>(node) - NODE_BYTES);
}

// Solves each batch, pass by pass, the one with the highest tension first. A later pass moves the nodes transversely
// to an earlier one, which changes its lengths by second order only; in the opposite order its tension would displace
// the slack pass by first order.
export function solveBatches(t: ConstraintTable): void {
  for (let i = 0; i < t.passCount; i++) {
    const pass = <i32>word(t.passes, MAX_PASSES + 1 + i);
    const end = <i32>word(t.passes, pass + 1);
    for (let batch = <i32>word(t.passes, pass); batch < end; batch++) {
      const first = <i32>word(t.batches, batch);
      const last = <i32>word(t.batches, batch + 1);
      const inexact = solveBatch(t, first, last, ALL_LANES);
      // The rotation of the rows changes their lengths by second order, so a large rotation needs a second solve.
      if (v128.any_true(inexact)) solveBatch(t, first, last, inexact);
    }
  }
}

// Tests whether the length of any row exceeds the tolerance after all passes: crossing polylines that carry each
// other's load undo each other's corrections. The pass solved last needs no test.
export function exceedsTolerance(t: ConstraintTable): bool {
  for (let i = 0; i < t.passCount - 1; i++) {
    const pass = <i32>word(t.passes, MAX_PASSES + 1 + i);
    const end = <i32>word(t.passes, pass + 1);
    for (let batch = <i32>word(t.passes, pass); batch < end; batch++) {
      if (batchExceedsTolerance(t, word(t.batches, batch), word(t.batches, batch + 1))) return true;
    }
  }
  return false;
}

function batchExceedsTolerance(t: ConstraintTable, first: i32, last: i32): bool {
  const packed = t.packed;
  const a = t.a + ((<usize>first) << 2);
  let b = t.b + ((<usize>first) << 2);
  let a0 = v128.load(vectorAddress(packed, a, 0));
  let a1 = v128.load(vectorAddress(packed, a, 1));
  let a2 = v128.load(vectorAddress(packed, a, 2));
  let a3 = v128.load(vectorAddress(packed, a, 3));
  let exceeding = splat(0);
  const end = at(last);
  for (let o = at(first); o < end; o += 16) {
    const b0 = v128.load(vectorAddress(packed, b, 0));
    const b1 = v128.load(vectorAddress(packed, b, 1));
    const b2 = v128.load(vectorAddress(packed, b, 2));
    const b3 = v128.load(vectorAddress(packed, b, 3));
    const r0 = sub(b0, a0);
    const r1 = sub(b1, a1);
    const r2 = sub(b2, a2);
    const r3 = sub(b3, a3);
    const x = transpose0(r0, r1, r2, r3);
    const y = transpose1(r0, r1, r2, r3);
    const z = transpose2(r0, r1, r2, r3);
    const length = v128.load(t.length + o);
    const restLength = add(v128.abs<real>(length), mul(v128.load(t.softness + o), v128.load(t.tension + o)));
    const expected = mul(restLength, restLength);
    const error = sub(dot(x, y, z, x, y, z), expected);
    // A tension-only row may be shorter than its natural length.
    const used = v128.andnot(v128.lt<real>(v128.load(t.gain + o), splat(Infinity)), signMask(v128.and(error, length)));
    const isOff = v128.gt<real>(v128.abs<real>(error), mul(splat(ITERATION_TOLERANCE), expected));
    exceeding = v128.or(exceeding, v128.and(isOff, used));
    a0 = b0;
    a1 = b1;
    a2 = b2;
    a3 = b3;
    b += LANES << 2;
  }
  return v128.any_true(exceeding);
}

// Solves the polylines of a batch whose bits are set in `mask`. Returns those whose rotation made lengths exceed the tolerance.
function solveBatch(t: ConstraintTable, first: i32, last: i32, mask: v128): v128 {
  eliminate(t, first, last);
  const taut = substitute(t, first, last, mask);
  if (v128.any_true(taut)) return moveTurning(t, first, last, taut);
  moveAlongRows(t, first, last);
  return taut;
}

// Loads one body of each polyline.
// @ts-ignore: decorator
@inline function gather(packed: usize, ids: usize, node: PolylineNode): void {
  const a = v128.load(vectorAddress(packed, ids, 0));
  const b = v128.load(vectorAddress(packed, ids, 1));
  const c = v128.load(vectorAddress(packed, ids, 2));
  const d = v128.load(vectorAddress(packed, ids, 3));
  node.x = transpose0(a, b, c, d);
  node.y = transpose1(a, b, c, d);
  node.z = transpose2(a, b, c, d);
  node.inverseMass = transpose3(a, b, c, d);
}

// Stores one body of each polyline.
// @ts-ignore: decorator
@inline function scatter(packed: usize, ids: usize, x: v128, y: v128, z: v128, inverseMass: v128): void {
  v128.store(vectorAddress(packed, ids, 0), transpose0(x, y, z, inverseMass));
  v128.store(vectorAddress(packed, ids, 1), transpose1(x, y, z, inverseMass));
  v128.store(vectorAddress(packed, ids, 2), transpose2(x, y, z, inverseMass));
  v128.store(vectorAddress(packed, ids, 3), transpose3(x, y, z, inverseMass));
}

// Forward elimination, from the first row to the last.
function eliminate(t: ConstraintTable, first: i32, last: i32): void {
  const zero = splat(0);
  const diagonals = t.gain;
  const compliances = t.softness;
  const lengths = t.length;
  const tensions = t.tension;
  const packed = t.packed;
  const end = at(last);
  let ids = t.b + ((<usize>first) << 2);
  let node = firstNode(t);
  gather(packed, t.a + ((<usize>first) << 2), node);
  let nx = zero;
  let ny = zero;
  let nz = zero;
  let pivotBefore = zero;
  let rhsBefore = zero;
  for (let o = at(first); o < end; o += 16) {
    const below = after(node);
    gather(packed, ids, below);
    ids += LANES << 2;
    let rx = sub(below.x, node.x);
    let ry = sub(below.y, node.y);
    let rz = sub(below.z, node.z);
    let square = dot(rx, ry, rz, rx, ry, rz);
    const isDegenerate = v128.lt<real>(square, splat(MIN_SQUARE));
    if (i32x4.bitmask(isDegenerate) != 0) {
      rx = v128.bitselect(splat(MIN_DISTANCE), rx, isDegenerate);
      ry = v128.andnot(ry, isDegenerate);
      rz = v128.andnot(rz, isDegenerate);
      square = v128.bitselect(splat(MIN_SQUARE), square, isDegenerate);
    }
    const d = v128.sqrt<real>(square);
    const inverseLength = div(splat(1), d);
    const mx = mul(rx, inverseLength);
    const my = mul(ry, inverseLength);
    const mz = mul(rz, inverseLength);
    const length = v128.load(lengths + o);
    const tension = v128.load(tensions + o);
    const restLength = add(v128.abs<real>(length), mul(v128.load(compliances + o), tension));
    const error = sub(d, restLength);
    const isUnloaded = v128.and(v128.le<real>(error, zero), v128.le<real>(tension, zero));
    const slack = v128.and(isUnloaded, signMask(length));
    const diagonal = v128.bitselect(splat(Infinity), v128.load(diagonals + o), slack);
    const lower = mul(node.inverseMass, dot(mx, my, mz, nx, ny, nz));
    node.upper = mul(lower, pivotBefore);
    // The previous pivot is on the critical path, so it is multiplied in last.
    const coupling = mul(mul(lower, lower), pivotBefore);
    const pivot = larger(sub(diagonal, coupling), mul(splat(MIN_PIVOT), diagonal));
    pivotBefore = div(splat(1), pivot);
    rhsBefore = mul(add(error, mul(lower, rhsBefore)), pivotBefore);
    node.rx = rx;
    node.ry = ry;
    node.rz = rz;
    node.inverseLength = inverseLength;
    node.restLength = restLength;
    node.rhs = rhsBefore;
    nx = mx;
    ny = my;
    nz = mz;
    node = below;
  }
}

// Back substitution, from the last row to the first: computes the impulses. Returns which polylines are taut.
function substitute(t: ConstraintTable, first: i32, last: i32, mask: v128): v128 {
  const compliances = t.softness;
  const lengths = t.length;
  const tensions = t.tension;
  const start = at(first);
  let node = lastNode(t, first, last);
  let inverseMassBelow = node.inverseMass;
  // The unknown of the row below, and its coefficient in the row above.
  let below = splat(0);
  let upper = splat(0);
  let taut = splat(0);
  for (let o = at(last); o > start; ) {
    o -= 16;
    node = before(node);
    below = add(node.rhs, mul(upper, below));
    upper = node.upper;
    const tension = v128.load(tensions + o);
    const expected = add(tension, below);
    const compressed = signMask(v128.and(expected, v128.load(lengths + o)));
    const total = v128.bitselect(v128.andnot(expected, compressed), tension, mask);
    v128.store(tensions + o, total);
    const impulse = sub(total, tension);
    const restLength = add(node.restLength, mul(v128.load(compliances + o), impulse));
    node.impulseOverLength = mul(impulse, node.inverseLength);
    node.restLength = restLength;
    const transverse = mul(impulse, add(node.inverseMass, inverseMassBelow));
    taut = v128.or(taut, v128.gt<real>(transverse, mul(splat(TAUT_RATIO), restLength)));
    inverseMassBelow = node.inverseMass;
  }
  return taut;
}

// Moves the bodies by impulses along n, for batches without taut polylines.
function moveAlongRows(t: ConstraintTable, first: i32, last: i32): void {
  const packed = t.packed;
  const end = lastNode(t, first, last);
  let ids = t.a + ((<usize>first) << 2);
  let fx = splat(0);
  let fy = splat(0);
  let fz = splat(0);
  let node = firstNode(t);
  for (; node != end; node = after(node)) {
    const w = node.inverseMass;
    const x = mul(node.impulseOverLength, node.rx);
    const y = mul(node.impulseOverLength, node.ry);
    const z = mul(node.impulseOverLength, node.rz);
    const toX = add(node.x, mul(w, sub(x, fx)));
    const toY = add(node.y, mul(w, sub(y, fy)));
    const toZ = add(node.z, mul(w, sub(z, fz)));
    scatter(packed, ids, toX, toY, toZ, w);
    ids += LANES << 2;
    fx = x;
    fy = y;
    fz = z;
  }
  const w = node.inverseMass;
  const lastIds = t.b + ((<usize>(last - LANES)) << 2);
  scatter(packed, lastIds, sub(node.x, mul(w, fx)), sub(node.y, mul(w, fy)), sub(node.z, mul(w, fz)), w);
}

// Moves the bodies by impulses that turn with the rows of taut polylines. Returns the taut ones that exceed the tolerance.
function moveTurning(t: ConstraintTable, first: i32, last: i32, taut: v128): v128 {
  const zero = splat(0);
  const one = splat(1);
  const end = lastNode(t, first, last);
  let node = firstNode(t);
  let fx = zero;
  let fy = zero;
  let fz = zero;
  let sx = zero;
  let sy = zero;
  let sz = zero;
  let above = zero;
  // 1 less the coefficient of the row above. As a difference it would be lost for rods without length, whose terms are of the order 10¹⁸.
  let left = one;
  for (; node != end; node = after(node)) {
    const w = node.inverseMass;
    const underTension = v128.and(taut, v128.gt<real>(node.impulseOverLength, zero));
    const endRatio = larger(mul(node.restLength, node.inverseLength), splat(MIN_END_LENGTH));
    const g = v128.and(div(node.impulseOverLength, endRatio), underTension);
    const scaled = v128.bitselect(g, node.impulseOverLength, underTension);
    const x = mul(scaled, node.rx);
    const y = mul(scaled, node.ry);
    const z = mul(scaled, node.rz);
    const from = mul(w, above);
    const own = add(one, mul(from, left));
    const inversePivot = div(one, add(own, mul(w, g)));
    sx = mul(add(mul(w, sub(x, fx)), mul(from, sx)), inversePivot);
    sy = mul(add(mul(w, sub(y, fy)), mul(from, sy)), inversePivot);
    sz = mul(add(mul(w, sub(z, fz)), mul(from, sz)), inversePivot);
    left = mul(own, inversePivot);
    above = g;
    fx = x;
    fy = y;
    fz = z;
    node.upper = mul(mul(w, g), inversePivot);
    node.rx = sx;
    node.ry = sy;
    node.rz = sz;
  }
  const from = mul(node.inverseMass, above);
  const inversePivot = div(one, add(one, mul(from, left)));
  sx = mul(sub(mul(from, sx), mul(node.inverseMass, fx)), inversePivot);
  sy = mul(sub(mul(from, sy), mul(node.inverseMass, fy)), inversePivot);
  sz = mul(sub(mul(from, sz), mul(node.inverseMass, fz)), inversePivot);
  return v128.and(moveBackward(t, first, last, sx, sy, sz), taut);
}

// Back substitution from the last body, with displacement s, to the first.
// @ts-ignore: decorator
@inline function moveBackward(t: ConstraintTable, first: i32, last: i32, endX: v128, endY: v128, endZ: v128): v128 {
  const packed = t.packed;
  const start = firstNode(t);
  let ids = t.a + ((<usize>last) << 2);
  let node = lastNode(t, first, last);
  let sx = endX;
  let sy = endY;
  let sz = endZ;
  let x = add(node.x, sx);
  let y = add(node.y, sy);
  let z = add(node.z, sz);
  scatter(packed, t.b + ((<usize>(last - LANES)) << 2), x, y, z, node.inverseMass);
  let inexact = splat(0);
  while (node != start) {
    node = before(node);
    sx = add(node.rx, mul(node.upper, sx));
    sy = add(node.ry, mul(node.upper, sy));
    sz = add(node.rz, mul(node.upper, sz));
    const toX = add(node.x, sx);
    const toY = add(node.y, sy);
    const toZ = add(node.z, sz);
    ids -= LANES << 2;
    scatter(packed, ids, toX, toY, toZ, node.inverseMass);
    const rx = sub(x, toX);
    const ry = sub(y, toY);
    const rz = sub(z, toZ);
    const expected = mul(node.restLength, node.restLength);
    const error = v128.abs<real>(sub(dot(rx, ry, rz, rx, ry, rz), expected));
    const isInexact = v128.gt<real>(error, mul(splat(SOLVE_TOLERANCE), expected));
    inexact = v128.or(inexact, v128.and(isInexact, v128.ne<real>(node.impulseOverLength, splat(0))));
    x = toX;
    y = toY;
    z = toZ;
  }
  return inexact;
}
