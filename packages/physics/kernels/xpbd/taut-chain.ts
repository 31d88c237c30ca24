// Chains so taut that transverse waves cross a link within the sub-step, solved implicitly: the minimum of
//
//   E(x) = sum m |x - x~|^2 / 2 + sum U_j(d_j)      x~ positions without springs, U_j energy of row j times h^2
//
// which is the backward Euler step, stable at any tension. Newton's method on all positions and tensions T of a
// chain, from one end to the other: everything above row j moves like a single body of mobility P_j (3 x 3, inverse
// mass), so that, with n the row's direction, e = 1/(k h^2) its compliance and g = T/d its transverse stiffness,
//
//   S_j = (P_j + e n n' + (1 - n n')/g)^-1            resistance of row j and all above it to motion of the next body b
//   P_j+1 = (m_b + S_j)^-1                            F_j = S_j (dx_b - P_j r_j + C_j n)        C = d - L
//   r_j+1 = m_b (x~_b - x_b) + S_j (P_j r_j - C_j n)  and back: dx_a = P_j (r_j + F_j)          T_j = n.F_j
//
// All are sums of positive definite matrices: nothing cancels, however many links and however rigid. A chain of N
// links with the start directions of chain.ts is unstable once N g h^2 exceeds a link. First order: a swing of
// angular frequency w loses about w^2 h/2 of its energy per second. Cost: 250 operations per link and iteration,
// of two to four.
import { get, put } from '../memory/columns';
import { ChainNode, complianceOf, mobilityOf, readBody, writeBody } from './chain-node';
import { Symmetric, invert } from './symmetric';
import { ConstraintTable, isTensionOnly, packedAt, packedComponent, word } from './table';

// Bytes of scratch memory per body of a chain.
const NODE_BYTES: usize = 232;
// The first tensions act along directions that are not yet the final ones, so a second iteration is needed even if
// all lengths fit.
const MIN_ITERATIONS: i32 = 2;
const MAX_ITERATIONS: i32 = 12;
// The maximum relative length error of an accepted solution.
const TOLERANCE: f64 = 1e-5;
// Minimum compliance times mass: a body on a rod from an anchor moves by no more than rounding.
const MIN_COMPLIANCE: f64 = 1e-12;
// Transverse stiffness over mass below which it is neglected.
const MIN_TRANSVERSE: f64 = 1e-4;

@unmanaged
class Node extends ChainNode {
  // r of the header.
  rx: f64;
  ry: f64;
  rz: f64;
  // S, n, C, e and g of the row to the next body.
  sxx: f64;
  sxy: f64;
  sxz: f64;
  syy: f64;
  syz: f64;
  szz: f64;
  nx: f64;
  ny: f64;
  nz: f64;
  error: f64;
  compliance: f64;
  transverse: f64;
  active: f64;
}

// @ts-ignore: decorator
@inline function nodeOf(t: ConstraintTable, row: i32): Node {
  return changetype<Node>(t.scratch + <usize>row * NODE_BYTES);
}

// The ratio T w/L above which explicit directions would be unstable: a transverse wave crosses a link in sqrt(L m/T),
// the sub-step if the ratio is 2.
const TAUT_RATIO: f64 = 0.5;

export function isTaut(t: ConstraintTable, first: i32, last: i32): bool {
  for (let row = first; row < last; row++) {
    const w =
      <f64>packedComponent(packedAt(t, word(t.a, row)), 3) + <f64>packedComponent(packedAt(t, word(t.b, row)), 3);
    if (<f64>get(t.tension, row) * w > TAUT_RATIO * abs<f64>(<f64>get(t.length, row))) return true;
  }
  return false;
}

// Solves the chain of rows [first, last) to the precision of `real`, starting from the tensions of the last sub-step.
// On failure returns false and moves no body.
export function solveTautChain(t: ConstraintTable, first: i32, last: i32): bool {
  const tolerance: f64 = sizeof<real>() == 4 ? 1e-5 : 1e-11;
  loadBodies(t, first, last);
  let error = Infinity;
  for (let i = 0; i <= MAX_ITERATIONS; i++) {
    error = updateRows(t, first, last, i > 0);

    if ((i >= MIN_ITERATIONS && error <= tolerance) || i == MAX_ITERATIONS) break;
    eliminate(t, first, last);
    substitute(t, first, last);
  }
  if (!(error <= TOLERANCE)) return false;
  for (let row = first; row <= last; row++) {
    const node = nodeOf(t, row);
    if (row < last && isTensionOnly(get(t.length, row))) put(t.tension, row, max<real>(0, get(t.tension, row)));
    writeBody(t, row, last, node);
  }
  return true;
}

function loadBodies(t: ConstraintTable, first: i32, last: i32): void {
  for (let row = first; row <= last; row++) readBody(t, row, last, nodeOf(t, row));
}

// Computes directions and errors of the rows; returns the largest relative length error. A tension-only row that was
// taut in an iteration stays taut for the sub-step; otherwise it could alternate between taut and slack for ever.
function updateRows(t: ConstraintTable, first: i32, last: i32, isRepeated: bool): f64 {
  let largestError: f64 = 0;
  for (let row = first; row < last; row++) {
    const a = nodeOf(t, row);
    const b = nodeOf(t, row + 1);
    const x = b.x - a.x;
    const y = b.y - a.y;
    const z = b.z - a.z;
    const d = sqrt<f64>(x * x + y * y + z * z);
    const isSeparate = d >= 1e-15;
    const inverseLength = isSeparate ? 1 / d : 0;
    a.nx = isSeparate ? x * inverseLength : 1;
    a.ny = y * inverseLength;
    a.nz = z * inverseLength;
    const gain = <f64>get(t.gain, row);
    const length = get(t.length, row);
    const restLength = abs<f64>(<f64>length);
    const tension = <f64>get(t.tension, row);
    const e = complianceOf(t, row);
    const slack = isTensionOnly(length) && d <= restLength && tension <= 0 && !(isRepeated && a.active > 0);
    const active = gain > 0 && !slack;
    const mass = a.mass + b.mass;
    const transverse = abs<f64>(tension) * inverseLength;
    a.error = d - restLength;
    a.compliance = max<f64>(e, MIN_COMPLIANCE / mass);
    a.transverse = transverse > MIN_TRANSVERSE * mass ? transverse : 0;
    a.active = active ? 1 : 0;
    if (active) largestError = max<f64>(largestError, abs<f64>(d - restLength - e * tension) / (d + restLength));
  }
  return largestError;
}

// Forward elimination.
function eliminate(t: ConstraintTable, first: i32, last: i32): void {
  for (let row = first; row <= last; row++) {
    const node = nodeOf(t, row);
    const m = node.mass;
    node.xx = node.yy = node.zz = m;
    node.xy = node.xz = node.yz = 0;
    node.rx = m * (node.toX - node.x);
    node.ry = m * (node.toY - node.y);
    node.rz = m * (node.toZ - node.z);
    if (row > first) addAbove(nodeOf(t, row - 1), node);
    if (m > 0) {
      invert(mobilityOf(node), node.xx, node.xy, node.xz, node.yy, node.yz, node.zz);
    } else node.xx = node.xy = node.xz = node.yy = node.yz = node.zz = 0;
    if (row < last) computeRowStiffness(node);
  }
}

// Computes S of the row below a body from the body's P.
// @ts-ignore: decorator
@inline function computeRowStiffness(node: Node): void {
  const x = node.nx;
  const y = node.ny;
  const z = node.nz;
  const e = node.compliance;
  if (node.active == 0) {
    node.sxx = node.sxy = node.sxz = node.syy = node.syz = node.szz = 0;
    return;
  }
  if (node.transverse == 0) {
    const qx = node.xx * x + node.xy * y + node.xz * z;
    const qy = node.xy * x + node.yy * y + node.yz * z;
    const qz = node.xz * x + node.yz * y + node.zz * z;
    const scale = 1 / (e + x * qx + y * qy + z * qz);
    node.sxx = scale * x * x;
    node.sxy = scale * x * y;
    node.sxz = scale * x * z;
    node.syy = scale * y * y;
    node.syz = scale * y * z;
    node.szz = scale * z * z;
    return;
  }
  const transverseCompliance = 1 / node.transverse;
  const k = e - transverseCompliance;
  const xx = node.xx + transverseCompliance + k * x * x;
  const yy = node.yy + transverseCompliance + k * y * y;
  const zz = node.zz + transverseCompliance + k * z * z;
  const xy = node.xy + k * x * y;
  const xz = node.xz + k * x * z;
  const yz = node.yz + k * y * z;
  invert(stiffnessOf(node), xx, xy, xz, yy, yz, zz);
}

// @ts-ignore: decorator
@inline function stiffnessOf(node: Node): Symmetric {
  return changetype<Symmetric>(changetype<usize>(node) + offsetof<Node>('sxx'));
}

// Adds S and the right-hand side of the row above to a body.
// @ts-ignore: decorator
@inline function addAbove(a: Node, node: Node): void {
  const x = a.xx * a.rx + a.xy * a.ry + a.xz * a.rz - a.error * a.nx;
  const y = a.xy * a.rx + a.yy * a.ry + a.yz * a.rz - a.error * a.ny;
  const z = a.xz * a.rx + a.yz * a.ry + a.zz * a.rz - a.error * a.nz;
  node.rx += a.sxx * x + a.sxy * y + a.sxz * z;
  node.ry += a.sxy * x + a.syy * y + a.syz * z;
  node.rz += a.sxz * x + a.syz * y + a.szz * z;
  node.xx += a.sxx;
  node.xy += a.sxy;
  node.xz += a.sxz;
  node.yy += a.syy;
  node.yz += a.syz;
  node.zz += a.szz;
}

// Back substitution: moves the bodies by the forces of the rows below them, whose component along the row is the
// tension.
function substitute(t: ConstraintTable, first: i32, last: i32): void {
  let dx: f64 = 0;
  let dy: f64 = 0;
  let dz: f64 = 0;
  for (let row = last; row >= first; row--) {
    const a = nodeOf(t, row);
    let rx = a.rx;
    let ry = a.ry;
    let rz = a.rz;
    if (row < last) {
      const x = dx - (a.xx * rx + a.xy * ry + a.xz * rz) + a.error * a.nx;
      const y = dy - (a.xy * rx + a.yy * ry + a.yz * rz) + a.error * a.ny;
      const z = dz - (a.xz * rx + a.yz * ry + a.zz * rz) + a.error * a.nz;
      const fx = a.sxx * x + a.sxy * y + a.sxz * z;
      const fy = a.sxy * x + a.syy * y + a.syz * z;
      const fz = a.sxz * x + a.syz * y + a.szz * z;
      const tension = fx * a.nx + fy * a.ny + fz * a.nz;
      put(t.tension, row, <real>tension);
      rx += fx;
      ry += fy;
      rz += fz;
    }
    dx = a.xx * rx + a.xy * ry + a.xz * rz;
    dy = a.xy * rx + a.yy * ry + a.yz * rz;
    dz = a.xz * rx + a.yz * ry + a.zz * rz;
    a.x += dx;
    a.y += dy;
    a.z += dz;
  }
}
