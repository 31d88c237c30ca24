// Taut chains of very unequal masses, where the iteration of taut-chain.ts does not converge: the same minimum, found
// from its dual. With multipliers l = T/d of the constraints (d^2 - L^2)/2 = 0, whose springs are linear, the positions
// are the solution of one tridiagonal system for x, y and z,
//
//   m x + l_above (x - x_above) + l_below (x - x_below) = m x~
//
// and the dual function q(l) = min over x of sum m |x - x~|^2/2 + l (d^2 - L^2)/2 is concave, with the gradient
// (d^2 - L^2)/2. So Newton's method with a line search ascends from any start. A row of compliance e has the length
// L/(1 - e l) instead of L.
//
// A step is eliminated from one end to the other, with P the mobility of a body and all before it, and q their motion
// without the rows after it. A row has the transverse stiffness l, so with B = (P + 1/l)^-1, v = B n, s its compliance
// along n, C = (d^2 - L^2)/2d, M = m_b + B, u = M^-1 v, k = s + v.u and y = v.(q - C n):
//
//   P_b = M^-1 - u u'/k        q_b = P_b B (q - C n) + u y/k        F = B (dx_b - q + C n) + v (u.(B (q - C n) + F_b) - y)/k
//
// Nothing is divided by s, which is zero in a straight chain from an anchor. Source: Bertsekas: Nonlinear Programming,
// section 6.1. Cost: 400 operations per row and iteration, of about ten.
import { get, put } from '../memory/columns';
import { ChainNode, complianceOf, mobilityOf, readBody, writeBody } from './chain-node';
import { Symmetric, invert } from './symmetric';
import { ConstraintTable, isTensionOnly } from './table';

// Bytes of scratch memory per body of a chain.
const NODE_BYTES: usize = 376;
const MAX_ITERATIONS: i32 = 40;
const MAX_HALVINGS: i32 = 20;
// The maximum relative length error of an accepted solution.
const TOLERANCE: f64 = 1e-3;
// The part of the expected ascent that a step must reach.
const ARMIJO: f64 = 1e-4;
// Multiplier over mass below which the transverse stiffness is neglected.
const MIN_TRANSVERSE: f64 = 1e-12;

@unmanaged
class Node extends ChainNode {
  // q of the header.
  qx: f64;
  qy: f64;
  qz: f64;
  // B, v, u, n, y, s and k of the row from this body to the next.
  bxx: f64;
  bxy: f64;
  bxz: f64;
  byy: f64;
  byz: f64;
  bzz: f64;
  vx: f64;
  vy: f64;
  vz: f64;
  ux: f64;
  uy: f64;
  uz: f64;
  nx: f64;
  ny: f64;
  nz: f64;
  product: f64;
  compliance: f64;
  divisor: f64;
  // C, distance d, expected length L/(1 - e l), l at the start of the iteration, its change, and l.
  error: f64;
  distance: f64;
  expected: f64;
  from: f64;
  change: f64;
  multiplier: f64;
  // Of the tridiagonal system: coefficient of the next body.
  coefficient: f64;
  active: f64;
}

// @ts-ignore: decorator
@inline function nodeOf(t: ConstraintTable, row: i32): Node {
  return changetype<Node>(t.scratch + <usize>row * NODE_BYTES);
}

// The largest relative length error at the last evaluation.
let largestError: f64 = 0;

// Solves the chain of rows [first, last). On failure returns false and moves no body.
export function solveDualChain(t: ConstraintTable, first: i32, last: i32): bool {
  const tolerance: f64 = sizeof<real>() == 4 ? 1e-6 : 1e-11;
  for (let row = first; row <= last; row++) {
    const node = nodeOf(t, row);
    readBody(t, row, last, node);
    node.from = node.change = 0;
  }
  let value = evaluate(t, first, last, 0);
  for (let i = 0; i < MAX_ITERATIONS && largestError > tolerance; i++) {
    const slope = findStep(t, first, last);
    const next = ascend(t, first, last, value, slope);
    if (!(next > -Infinity)) {
      evaluate(t, first, last, 0);
      break;
    }
    value = next;
  }
  if (!(largestError <= TOLERANCE)) return false;
  for (let row = first; row <= last; row++) {
    const node = nodeOf(t, row);
    if (row < last) put(t.tension, row, <real>(node.multiplier * node.distance));
    writeBody(t, row, last, node);
  }
  return true;
}

// Halves the step until the dual function increases enough, and returns its value; -Infinity if it does not. Near the
// solution its changes are rounding errors, and the length errors decide.
function ascend(t: ConstraintTable, first: i32, last: i32, value: f64, slope: f64): f64 {
  const error = largestError;
  let part: f64 = 1;
  for (let i = 0; i < MAX_HALVINGS; i++) {
    const next = evaluate(t, first, last, part);
    if (next >= value + ARMIJO * part * slope || (i == 0 && largestError < 0.5 * error)) return next;
    part *= 0.5;
  }
  return -Infinity;
}

// Sets the multipliers to `part` of the step, and the positions to theirs; returns the dual function, or NaN if it has
// no minimum.
function evaluate(t: ConstraintTable, first: i32, last: i32, part: f64): f64 {
  let above: f64 = 0;
  let coefficient: f64 = 0;
  let sx: f64 = 0;
  let sy: f64 = 0;
  let sz: f64 = 0;
  let fx: f64 = 0;
  let fy: f64 = 0;
  let fz: f64 = 0;
  largestError = Infinity;
  for (let row = first; row <= last; row++) {
    const node = nodeOf(t, row);
    const next = nodeOf(t, row + 1);
    const from = above * (1 - coefficient);
    const raised = above;
    above = 0;
    let rx = raised * sx - fx;
    let ry = raised * sy - fy;
    let rz = raised * sz - fz;
    fx = fy = fz = 0;
    if (row < last) {
      above = node.from + part * node.change;
      if (isTensionOnly(get(t.length, row))) above = max<f64>(above, 0);
      node.multiplier = above;
      fx = above * (next.toX - node.toX);
      fy = above * (next.toY - node.toY);
      fz = above * (next.toZ - node.toZ);
    }
    rx += fx;
    ry += fy;
    rz += fz;
    const pivot = node.mass + above + from;
    if (node.mass > 0 && !(pivot > 0)) return NaN;
    const scale = node.mass > 0 ? 1 / pivot : 0;
    node.coefficient = coefficient = above * scale;
    node.x = sx = rx * scale;
    node.y = sy = ry * scale;
    node.z = sz = rz * scale;
  }
  return measure(t, first, last);
}

// Substitutes back, and returns the dual function.
function measure(t: ConstraintTable, first: i32, last: i32): f64 {
  let value: f64 = 0;
  let largest: f64 = 0;
  for (let row = last; row >= first; row--) {
    const node = nodeOf(t, row);
    const next = nodeOf(t, row + 1);
    if (row < last) {
      node.x += node.coefficient * (next.x - next.toX);
      node.y += node.coefficient * (next.y - next.toY);
      node.z += node.coefficient * (next.z - next.toZ);
    }
    value += 0.5 * node.mass * (node.x * node.x + node.y * node.y + node.z * node.z);
    node.x += node.toX;
    node.y += node.toY;
    node.z += node.toZ;
    if (row == last) continue;
    const e = complianceOf(t, row);
    const l = node.multiplier;
    if (!(e * l < 1)) return NaN;
    const x = next.x - node.x;
    const y = next.y - node.y;
    const z = next.z - node.z;
    const d = sqrt<f64>(x * x + y * y + z * z);
    const restLength = abs<f64>(<f64>get(t.length, row));
    const expected = restLength / (1 - e * l);
    const isSeparate = d >= 1e-15;
    node.nx = isSeparate ? x / d : 1;
    node.ny = isSeparate ? y / d : 0;
    node.nz = isSeparate ? z / d : 0;
    node.distance = d;
    node.expected = expected;
    const isSlack = isTensionOnly(get(t.length, row)) && d <= expected && l == 0;
    node.active = get(t.gain, row) > 0 && !isSlack ? 1 : 0;
    value += 0.5 * l * ((d - expected) * (d + expected) + e * l * expected * expected);
    if (node.active > 0) largest = max<f64>(largest, abs<f64>(d - expected) / (d + restLength));
  }
  largestError = largest;
  return value;
}

// Computes Newton's step of the multipliers, and returns the ascent of the dual function along it.
function findStep(t: ConstraintTable, first: i32, last: i32): f64 {
  for (let row = first; row <= last; row++) {
    const node = nodeOf(t, row);
    if (row == first) {
      node.xx = node.yy = node.zz = node.mass > 0 ? 1 / node.mass : 0;
      node.xy = node.xz = node.yz = node.qx = node.qy = node.qz = 0;
    }
    if (row == last) break;
    prepareRow(t, row, node, nodeOf(t, row + 1));
    eliminateRow(node, nodeOf(t, row + 1));
  }
  return substitute(t, first, last);
}

// Computes C, B, v and s of a row.
// @ts-ignore: decorator
@inline function prepareRow(t: ConstraintTable, row: i32, a: Node, b: Node): void {
  const l = a.multiplier;
  const e = complianceOf(t, row);
  const d = max<f64>(a.distance, 1e-15);
  // ds/dl of s = L^2/(1 - e l)^2/2, over d^2.
  const yielding = (e * a.expected * a.expected) / ((1 - e * l) * d * d);
  const scale = 1 / (1 + yielding * l);
  a.from = l;
  a.compliance = yielding * scale;
  a.error = (0.5 * (a.distance - a.expected) * (a.distance + a.expected) * scale) / d;
  const g = abs<f64>(l);
  const x = a.nx;
  const y = a.ny;
  const z = a.nz;
  if (g <= MIN_TRANSVERSE * (a.mass + b.mass)) {
    a.bxx = a.bxy = a.bxz = a.byy = a.byz = a.bzz = 0;
    a.vx = x;
    a.vy = y;
    a.vz = z;
    const along = x * x * a.xx + y * y * a.yy + z * z * a.zz + 2 * (x * y * a.xy + x * z * a.xz + y * z * a.yz);
    a.divisor = a.compliance + max<f64>(along, 0);
    return;
  }
  invert(inverseOf(a), a.xx + 1 / g, a.xy, a.xz, a.yy + 1 / g, a.yz, a.zz + 1 / g);
  a.vx = a.bxx * x + a.bxy * y + a.bxz * z;
  a.vy = a.bxy * x + a.byy * y + a.byz * z;
  a.vz = a.bxz * x + a.byz * y + a.bzz * z;
  a.divisor = max<f64>(g / (1 - a.compliance * g) - (a.vx * x + a.vy * y + a.vz * z), 0);
}

// @ts-ignore: decorator
@inline function inverseOf(node: Node): Symmetric {
  return changetype<Symmetric>(changetype<usize>(node) + offsetof<Node>('bxx'));
}

// Computes P and q of the body after a row.
// @ts-ignore: decorator
@inline function eliminateRow(a: Node, b: Node): void {
  const m = b.mass;
  b.xx = b.yy = b.zz = m > 0 ? 1 / m : 0;
  b.xy = b.xz = b.yz = b.qx = b.qy = b.qz = 0;
  if (a.active == 0) return;
  const x = a.qx - a.error * a.nx;
  const y = a.qy - a.error * a.ny;
  const z = a.qz - a.error * a.nz;
  a.product = a.vx * x + a.vy * y + a.vz * z;
  if (m == 0) return;
  invert(mobilityOf(b), m + a.bxx, a.bxy, a.bxz, m + a.byy, a.byz, m + a.bzz);
  const ux = (a.ux = b.xx * a.vx + b.xy * a.vy + b.xz * a.vz);
  const uy = (a.uy = b.xy * a.vx + b.yy * a.vy + b.yz * a.vz);
  const uz = (a.uz = b.xz * a.vx + b.yz * a.vy + b.zz * a.vz);
  a.divisor += a.vx * ux + a.vy * uy + a.vz * uz;
  const k = 1 / a.divisor;
  b.xx -= k * ux * ux;
  b.xy -= k * ux * uy;
  b.xz -= k * ux * uz;
  b.yy -= k * uy * uy;
  b.yz -= k * uy * uz;
  b.zz -= k * uz * uz;
  const fx = a.bxx * x + a.bxy * y + a.bxz * z;
  const fy = a.bxy * x + a.byy * y + a.byz * z;
  const fz = a.bxz * x + a.byz * y + a.bzz * z;
  b.qx = b.xx * fx + b.xy * fy + b.xz * fz + k * a.product * ux;
  b.qy = b.xy * fx + b.yy * fy + b.yz * fz + k * a.product * uy;
  b.qz = b.xz * fx + b.yz * fy + b.zz * fz + k * a.product * uz;
}

// Back substitution, from the last row to the first: the force F of a row gives the change of its multiplier.
function substitute(t: ConstraintTable, first: i32, last: i32): f64 {
  let slope: f64 = 0;
  let fx: f64 = 0;
  let fy: f64 = 0;
  let fz: f64 = 0;
  for (let row = last - 1; row >= first; row--) {
    const a = nodeOf(t, row);
    const b = nodeOf(t, row + 1);
    a.change = 0;
    if (a.active == 0) {
      fx = fy = fz = 0;
      continue;
    }
    const x = a.qx - a.error * a.nx;
    const y = a.qy - a.error * a.ny;
    const z = a.qz - a.error * a.nz;
    const rx = fx + a.bxx * x + a.bxy * y + a.bxz * z;
    const ry = fy + a.bxy * x + a.byy * y + a.byz * z;
    const rz = fz + a.bxz * x + a.byz * y + a.bzz * z;
    // A straight chain between two anchors is overdetermined: one of its rows is redundant.
    const isRedundant = b.mass == 0 && !(a.divisor > 1e-12 * abs<f64>(a.multiplier));
    const gain = b.mass == 0 ? 0 : a.ux * rx + a.uy * ry + a.uz * rz;
    const along = isRedundant ? 0 : (gain - a.product) / a.divisor;
    const dx = b.qx + b.xx * fx + b.xy * fy + b.xz * fz - x;
    const dy = b.qy + b.xy * fx + b.yy * fy + b.yz * fz - y;
    const dz = b.qz + b.xz * fx + b.yz * fy + b.zz * fz - z;
    fx = a.bxx * dx + a.bxy * dy + a.bxz * dz + a.vx * along;
    fy = a.bxy * dx + a.byy * dy + a.byz * dz + a.vy * along;
    fz = a.bxz * dx + a.byz * dy + a.bzz * dz + a.vz * along;
    const force = fx * a.nx + fy * a.ny + fz * a.nz;
    const d = max<f64>(a.distance, 1e-15);
    a.change = (force - a.multiplier * (a.compliance * force - a.error)) / d;
    slope += 0.5 * a.change * (a.distance - a.expected) * (a.distance + a.expected);
  }
  return slope;
}
