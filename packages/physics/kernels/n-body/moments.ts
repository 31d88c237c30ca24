// Strength, centre, dipole, second moments and size of every node, computed from the leaves up.
//
// The centre is weighted by absolute strengths, so that it lies among the bodies even if charges cancel; for strengths
// of one sign the dipole about it vanishes. Second moments S = sum s x x keep their trace, because softened laws and
// 1/r² in 2D are not harmonic.
import { get } from '../memory/columns';
import { LINK_BYTES, NBody, NEAR2, NODE_BYTES, REAL, SIZE, SUM_BYTES } from './workspace';

// Nodes up to this many bodies store the exact distance of their farthest body; larger nodes a bound from their
// children.
const MAX_EXACT_BODIES: i32 = 512;

// A cell may be accepted by a group closer than its farthest body, down to this fraction of the cell's radius, if the
// error bound allows it. The faces of a cube are at 0.58 of the distance of its corners, so the group still lies
// outside. Measured at equal error: 0.65 needs a third fewer cells than 1.05.
const ACCEPTANCE_FRACTION: f64 = 0.65;

// Distances below this fraction of the coordinates are lost in their rounding.
// @ts-ignore: decorator
@inline function epsilon(): f64 {
  return sizeof<real>() == 4 ? 5e-7 : 1e-15;
}

// The seventh power of this distance is still a normal number.
// @ts-ignore: decorator
@inline function minDistance(): f64 {
  return sizeof<real>() == 4 ? 1e-5 : 1e-12;
}

// Sums of the current node.
let strength: f64 = 0;
let weight: f64 = 0;
let centreX: f64 = 0;
let centreY: f64 = 0;
let centreZ: f64 = 0;
let dipoleX: f64 = 0;
let dipoleY: f64 = 0;
let dipoleZ: f64 = 0;
let sxx: f64 = 0;
let sxy: f64 = 0;
let sxz: f64 = 0;
let syy: f64 = 0;
let syz: f64 = 0;
let szz: f64 = 0;
let spread: f64 = 0;
let radius: f64 = 0;

function clear(): void {
  strength = weight = centreX = centreY = centreZ = dipoleX = dipoleY = dipoleZ = 0;
  sxx = sxy = sxz = syy = syz = szz = spread = radius = 0;
}

// @ts-ignore: decorator
@inline function addCentre(s: f64, by: f64, x: f64, y: f64, z: f64): void {
  strength += s;
  weight += by;
  centreX += by * x;
  centreY += by * y;
  centreZ += by * z;
}

// Rounds the centre to its stored precision, so that the moments refer to the stored point. A node of test particles
// has no strength, so its centre is its first body.
function roundCentre(x: real, y: real, z: real): void {
  const by = weight > 0 ? 1 / weight : 0;
  centreX = weight > 0 ? <f64>(<real>(centreX * by)) : <f64>x;
  centreY = weight > 0 ? <f64>(<real>(centreY * by)) : <f64>y;
  centreZ = weight > 0 ? <f64>(<real>(centreZ * by)) : <f64>z;
}

// Sums coincident bodies, of any number, into one point.
function sumPoint(w: NBody, first: i32, last: i32): void {
  for (let i = first; i < last; i++) {
    const s = <f64>get(w.ps, i);
    strength += s;
    weight += abs<f64>(s);
  }
  centreX = <f64>get(w.px, first);
  centreY = <f64>get(w.py, first);
  centreZ = <f64>get(w.pz, first);
}

function sumBodies(w: NBody, first: i32, last: i32): void {
  for (let i = first; i < last; i++) {
    const s = <f64>get(w.ps, i);
    addCentre(s, abs<f64>(s), <f64>get(w.px, i), <f64>get(w.py, i), <f64>get(w.pz, i));
  }
  roundCentre(get(w.px, first), get(w.py, first), get(w.pz, first));
  for (let i = first; i < last; i++) {
    const s = <f64>get(w.ps, i);
    const x = <f64>get(w.px, i) - centreX;
    const y = <f64>get(w.py, i) - centreY;
    const z = <f64>get(w.pz, i) - centreZ;
    dipoleX += s * x;
    dipoleY += s * y;
    dipoleZ += s * z;
    sxx += s * x * x;
    sxy += s * x * y;
    sxz += s * x * z;
    syy += s * y * y;
    syz += s * y * z;
    szz += s * z * z;
    spread += abs<f64>(s) * (x * x + y * y + z * z);
  }
}

// @ts-ignore: decorator
@inline function num(node: usize, index: usize): f64 {
  return <f64>load<real>(node + index * REAL);
}

// @ts-ignore: decorator
@inline function nextOf(w: NBody, node: i32): i32 {
  return load<i32>(w.links + <usize>node * LINK_BYTES);
}

function sumChildren(w: NBody, node: i32, next: i32, perFactor: f64): void {
  for (let c = node + 1; c < next; c = nextOf(w, c)) {
    const p = w.nodes + <usize>c * NODE_BYTES;
    addCentre(num(p, 3), load<f64>(w.sums + <usize>c * SUM_BYTES), num(p, 0), num(p, 1), num(p, 2));
  }
  const one = w.nodes + <usize>(node + 1) * NODE_BYTES;
  roundCentre(load<real>(one), load<real>(one + REAL), load<real>(one + 2 * REAL));
  for (let c = node + 1; c < next; c = nextOf(w, c)) {
    const p = w.nodes + <usize>c * NODE_BYTES;
    const sums = w.sums + <usize>c * SUM_BYTES;
    const s = num(p, 3);
    const x = num(p, 0) - centreX;
    const y = num(p, 1) - centreY;
    const z = num(p, 2) - centreZ;
    const dx = num(p, 11);
    const dy = num(p, 12);
    const dz = num(p, 13);
    dipoleX += dx + s * x;
    dipoleY += dy + s * y;
    dipoleZ += dz + s * z;
    sxx += num(p, 4) * perFactor + (s * x + 2 * dx) * x;
    sxy += num(p, 5) * perFactor + s * x * y + dx * y + dy * x;
    sxz += num(p, 6) * perFactor + s * x * z + dx * z + dz * x;
    syy += num(p, 7) * perFactor + (s * y + 2 * dy) * y;
    syz += num(p, 8) * perFactor + s * y * z + dy * z + dz * y;
    szz += num(p, 9) * perFactor + (s * z + 2 * dz) * z;
    const d2 = x * x + y * y + z * z;
    spread += load<f64>(sums, 8) + load<f64>(sums) * d2;
    radius = max<f64>(radius, sqrt<f64>(d2) + load<f64>(sums, 16));
  }
}

function farthest(w: NBody, first: i32, last: i32): void {
  let maxSquare: f64 = 0;
  for (let i = first; i < last; i++) {
    const x = <f64>get(w.px, i) - centreX;
    const y = <f64>get(w.py, i) - centreY;
    const z = <f64>get(w.pz, i) - centreZ;
    maxSquare = max<f64>(maxSquare, x * x + y * y + z * z);
  }
  radius = sqrt<f64>(maxSquare);
}

function write(w: NBody, node: i32, factor: f64): void {
  const p = w.nodes + <usize>node * NODE_BYTES;
  store<real>(p, <real>centreX);
  store<real>(p + REAL, <real>centreY);
  store<real>(p + 2 * REAL, <real>centreZ);
  store<real>(p + 3 * REAL, <real>strength);
  store<real>(p + 4 * REAL, <real>(factor * sxx));
  store<real>(p + 5 * REAL, <real>(factor * sxy));
  store<real>(p + 6 * REAL, <real>(factor * sxz));
  store<real>(p + 7 * REAL, <real>(factor * syy));
  store<real>(p + 8 * REAL, <real>(factor * syz));
  store<real>(p + 9 * REAL, <real>(factor * szz));
  store<real>(p + 10 * REAL, <real>(0.5 * factor * (sxx + syy + szz)));
  store<real>(p + 11 * REAL, <real>dipoleX);
  store<real>(p + 12 * REAL, <real>dipoleY);
  store<real>(p + 13 * REAL, <real>dipoleZ);
  const sums = w.sums + <usize>node * SUM_BYTES;
  store<f64>(sums, weight);
  store<f64>(sums, spread, 8);
  store<f64>(sums, radius, 16);
  // The size that bounds the first neglected moment; nodes of test particles alone are skipped.
  store<real>(p + SIZE, weight > 0 ? <real>(spread * radius) : -1);
  const rounding = epsilon() * (abs<f64>(centreX) + abs<f64>(centreY) + abs<f64>(centreZ));
  const near = max<f64>(radius * ACCEPTANCE_FRACTION, max<f64>(rounding, minDistance()));
  store<real>(p + NEAR2, <real>(near * near));
}

// Fills all nodes; second moments are stored times `factor`.
export function moments(w: NBody, factor: f64): void {
  for (let node = w.nodeCount - 1; node >= 0; node--) {
    const link = w.links + <usize>node * LINK_BYTES;
    const next = load<i32>(link);
    const first = load<i32>(link, 4);
    const last = load<i32>(link, 8);
    clear();
    if (load<i32>(link, 12)) sumPoint(w, first, last);
    else if (next == node + 1) sumBodies(w, first, last);
    else sumChildren(w, node, next, 1 / factor);
    if (load<i32>(link, 12) == 0 && (last - first <= MAX_EXACT_BODIES || next == node + 1)) farthest(w, first, last);
    write(w, node, factor);
  }
}
