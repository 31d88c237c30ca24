// Potential energy of a mutual force, summed in f64: directly, or with the interaction lists of the forces.
//
// W = sum over pairs s s' psi, plus the strength of each test particle times psi of all sources, with psi = u^(-1/2)
// for the law 1/r² and -ln(u)/2 for 1/r, u = d² + ε² in units of the system's length. A diagnostic: scalar, 5 ns per
// pair, 30 ns with a logarithm. Without softening, coincident bodies have no mutual energy, as they have no force.
import { get } from '../memory/columns';
import { logarithm } from '../math/elementary';
import { listGroupInteractions, prepareTree } from './forces';
import { LINK_BYTES, NBody, NODE_BYTES, REAL, coincident2 } from './workspace';

// @ts-ignore: decorator
@inline function psi(d2: f64, soft: f64, law: i32): f64 {
  if (d2 == 0 && soft <= coincident2()) return 0;
  const u = d2 + soft;
  return law == 2 ? 1 / sqrt<f64>(u) : -0.5 * logarithm(u);
}

// Sum of s psi over positions [first, last) of the columns, excluding the body at `self`.
function potentialOfBodies(
  xs: usize,
  ys: usize,
  zs: usize,
  ss: usize,
  first: i32,
  last: i32,
  self: i32,
  x: f64,
  y: f64,
  z: f64,
  soft: f64,
  law: i32,
): f64 {
  let sum: f64 = 0;
  for (let j = first; j < last; j++) {
    const s = <f64>get(ss, j);
    if (s == 0 || j == self) continue;
    const dx = <f64>get(xs, j) - x;
    const dy = <f64>get(ys, j) - y;
    const dz = <f64>get(zs, j) - z;
    sum += s * psi(dx * dx + dy * dy + dz * dz, soft, law);
  }
  return sum;
}

// @ts-ignore: decorator
@inline function valueAt(node: usize, index: usize): f64 {
  return <f64>load<real>(node + index * REAL);
}

// A cell's expansion to second order, in the notation of evaluate-3d.ts.
function potentialOfCell(p: usize, x: f64, y: f64, z: f64, soft: f64, law: i32): f64 {
  const dx = valueAt(p, 0) - x;
  const dy = valueAt(p, 1) - y;
  const dz = valueAt(p, 2) - z;
  const u = dx * dx + dy * dy + dz * dz + soft;
  const sx = valueAt(p, 4) * dx + valueAt(p, 5) * dy + valueAt(p, 6) * dz;
  const sy = valueAt(p, 5) * dx + valueAt(p, 7) * dy + valueAt(p, 8) * dz;
  const sz = valueAt(p, 6) * dx + valueAt(p, 8) * dy + valueAt(p, 9) * dz;
  const ds = dx * sx + dy * sy + dz * sz;
  const dipole = valueAt(p, 11) * dx + valueAt(p, 12) * dy + valueAt(p, 13) * dz;
  const trace = valueAt(p, 10);
  if (law == 2) {
    const r1 = 1 / sqrt<f64>(u);
    const r3 = r1 / u;
    return valueAt(p, 3) * r1 + (0.5 * ds * r3) / u - (trace / 3 + dipole) * r3;
  }
  const w = 1 / u;
  return -0.5 * valueAt(p, 3) * logarithm(u) + (0.5 * ds * w - 0.5 * trace - dipole) * w;
}

// Coincident bodies; the body at position `self` may be among them.
function potentialOfPoint(w: NBody, p: usize, self: i32, law: i32): f64 {
  const dx = valueAt(p, 0) - <f64>get(w.px, self);
  const dy = valueAt(p, 1) - <f64>get(w.py, self);
  const dz = valueAt(p, 2) - <f64>get(w.pz, self);
  const link = w.links + <usize>((p - w.nodes) / NODE_BYTES) * LINK_BYTES;
  const isMember = self >= load<i32>(link, 4) && self < load<i32>(link, 8);
  const strength = valueAt(p, 3) - (isMember ? <f64>get(w.ps, self) : 0);
  return strength * psi(dx * dx + dy * dy + dz * dz, w.softening2, law);
}

function direct(w: NBody, column: usize, law: i32): f64 {
  let sum: f64 = 0;
  for (let i = 0; i < w.end; i++) {
    const row = load<u32>(w.ids + ((<usize>i) << 2));
    if (row == 0) continue;
    const isSource = i < w.sources;
    const weight = isSource ? <f64>get(w.s, i) : <f64>get(column, row) / w.strength;
    // Pairs of sources count once; a test particle interacts with all sources.
    const last = isSource ? i : w.sources;
    const x = <f64>get(w.x, i);
    const y = <f64>get(w.y, i);
    const z = <f64>get(w.z, i);
    sum += weight * potentialOfBodies(w.x, w.y, w.z, w.s, 0, last, i, x, y, z, w.softening2, law);
  }
  return sum;
}

function byTree(w: NBody, column: usize, dimensions: i32, law: i32): f64 {
  prepareTree(w, dimensions, law);
  let sum: f64 = 0;
  for (let g = 0; g < w.groupCount; g++) {
    const group = w.groups + ((<usize>g) << 3);
    listGroupInteractions(w, g, law);
    for (let i = load<i32>(group); i < load<i32>(group, 4); i++) {
      const x = <f64>get(w.px, i);
      const y = <f64>get(w.py, i);
      const z = <f64>get(w.pz, i);
      let potential: f64 = 0;
      for (let c = 0; c < w.cellCount; c++) {
        potential += potentialOfCell(<usize>load<u32>(w.cells + ((<usize>c) << 2)), x, y, z, w.softening2, law);
      }
      for (let q = 0; q < w.pointCount; q++)
        potential += potentialOfPoint(w, <usize>load<u32>(w.points + ((<usize>q) << 2)), i, law);
      for (let r = 0; r < w.rangeCount; r++) {
        const range = w.ranges + ((<usize>r) << 3);
        const first = load<i32>(range);
        const last = load<i32>(range, 4);
        potential += potentialOfBodies(w.px, w.py, w.pz, w.ps, first, last, i, x, y, z, w.softening2, law);
      }
      const slot = load<i32>(w.order + ((<usize>i) << 2));
      const row = load<u32>(w.ids + ((<usize>slot) << 2));
      sum += slot < w.sources ? 0.5 * <f64>get(w.ps, i) * potential : (<f64>get(column, row) / w.strength) * potential;
    }
  }
  return sum;
}

// Sum of s s' over the pairs of W: the change of a logarithmic potential with the unit of length.
function pairStrength(w: NBody, column: usize): f64 {
  let total: f64 = 0;
  let squares: f64 = 0;
  let tests: f64 = 0;
  for (let i = 0; i < w.end; i++) {
    const row = load<u32>(w.ids + ((<usize>i) << 2));
    if (row == 0) continue;
    const s = <f64>get(w.s, i);
    total += s;
    squares += s * s;
    if (i >= w.tests) tests += <f64>get(column, row) / w.strength;
  }
  return 0.5 * (total * total - squares) + tests * total;
}

// Returns W of the packed bodies, which must have been evaluated: in strength²/m for the law 1/r², in strength² with
// distances in metres for 1/r.
export function nBodyPotential(address: usize, column: usize, dimensions: i32, law: i32): f64 {
  const w = changetype<NBody>(address);
  if (w.bodies == 0) return 0;
  const sum = w.resultsByTree ? byTree(w, column, dimensions, law) : direct(w, column, law);
  const units = w.strength * w.strength;
  if (law == 2) return (sum * units) / w.length;
  return units * (sum - pairStrength(w, column) * logarithm(w.length));
}
