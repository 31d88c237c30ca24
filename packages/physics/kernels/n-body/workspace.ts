// The working memory of one mutual force: bodies packed by slot, the same bodies in tree order, the tree, the lists of
// one group, results. Lengths are in units of `length` and strengths in units of `strength`. Both are powers of two,
// near the extent of the system unless a few bodies are far away, and near the strongest body: scaling by them is exact,
// and no unit system overflows f32.
import { BINS } from './approximate-median';

@unmanaged
export class NBody {
  // Slots: sources at [0, sources), padding without strength, then test particles at [tests, end).
  capacity: i32;
  sources: i32;
  tests: i32;
  end: i32;
  // 1 if memory for the tree and its lists is allocated.
  hasTree: i32;
  nodeCapacity: i32;
  ids: usize;
  x: usize;
  y: usize;
  z: usize;
  s: usize;
  // Results by slot (direct) or by position in the tree: force between the sources, otherwise acceleration.
  ax: usize;
  ay: usize;
  az: usize;
  // Histogram counts.
  counts: usize;
  // Tree order: slot of each position, and copies of the columns.
  order: usize;
  px: usize;
  py: usize;
  pz: usize;
  ps: usize;
  // Buffers for sorting, free afterwards.
  keys: usize;
  spareKeys: usize;
  spareOrder: usize;
  // The tree, depth first: values and links of each node; groups as pairs of positions; lists of the current group.
  nodes: usize;
  links: usize;
  sums: usize;
  groups: usize;
  groupFields: usize;
  cells: usize;
  points: usize;
  ranges: usize;
  sample: usize;
  bodies: i32;
  nodeCount: i32;
  groupCount: i32;
  cellCount: i32;
  pointCount: i32;
  rangeCount: i32;
  listedBodies: i32;
  // Which data is up to date with the slots.
  treeValid: i32;
  resultsValid: i32;
  resultsByTree: i32;
  // The deepest level at which a node was split, for tests.
  maxDepth: i32;
  evaluations: i32;
  length: f64;
  strength: f64;
  // Lowest corner of the slots.
  lowX: f64;
  lowY: f64;
  lowZ: f64;
  // Softening length squared, in units of length².
  softening2: f64;
  // Side of the root cell, in units of length: a power of two, 1 unless a few bodies are far away.
  side: f64;
  // Permitted error of a cell relative to the field scale, and the error measured last.
  tolerance: f64;
  error: f64;
  // Running estimate of the mean square error; 0 before the first measurement.
  meanSquare: f64;
  // Target-source pairs of the last evaluation.
  cellPairs: f64;
  bodyPairs: f64;
}

// @ts-ignore: decorator
@inline export const SAMPLES: i32 = 1024;

// Values per node, in reals; the order of the expansion is that of evaluate-3d.ts.
// @ts-ignore: decorator
@inline export const NODE_REALS: i32 = 16;
// @ts-ignore: decorator
@inline export const NODE_BYTES: usize = <usize>NODE_REALS * sizeof<real>();
// Links of a node: the node after its subtree, first and last position of its bodies, and 1 if all coincide.
// @ts-ignore: decorator
@inline export const LINK_BYTES: usize = 16;
// Further values per node for its parent: absolute strength, sum |s| x², distance of its farthest body; f64 each.
// @ts-ignore: decorator
@inline export const SUM_BYTES: usize = 24;

// Offsets of a node's values: centre, strength, second moments times the law's factor, half their trace, dipole, the
// size for the acceptance test, and the squared distance within which its expansion is invalid.
// @ts-ignore: decorator
@inline export const REAL: usize = sizeof<real>();
// @ts-ignore: decorator
@inline export const SIZE: usize = 14 * REAL;
// @ts-ignore: decorator
@inline export const NEAR2: usize = 15 * REAL;

// Squared distance below which bodies count as coincident, in units of the extent: its 3/2 power is still a normal
// number.
// @ts-ignore: decorator
@inline export function coincident2(): f64 {
  // In f32, the attraction of a million bodies at one point must not overflow if this square is raised to 3/2.
  return sizeof<real>() == 4 ? 1e-20 : 1e-200;
}

let cursor: usize = 0;
let allocationCount: i32 = 0;

// Arrays start at staggered offsets within a page, so that loops over several arrays do not compete for cache sets.
function allocate(bytes: usize): usize {
  cursor = ((cursor + 63) & ~63) + <usize>((allocationCount++ & 7) * 320);
  const start = cursor;
  cursor += bytes;
  return start;
}

function slotBytes(count: i32): usize {
  return <usize>(count + 64) * sizeof<real>();
}

// Lays out the arrays behind `w` for `capacity` bodies and a tree of `nodeCapacity` nodes (0 for none), and returns the
// end. Without `write` it only measures.
function layOut(w: NBody, base: usize, capacity: i32, nodeCapacity: i32, write: bool): usize {
  cursor = base + offsetof<NBody>();
  allocationCount = 0;
  const reals = slotBytes(capacity);
  const words = (<usize>(capacity + 64)) << 2;
  const ids = allocate(words);
  const x = allocate(reals);
  const y = allocate(reals);
  const z = allocate(reals);
  const s = allocate(reals);
  const ax = allocate(reals);
  const ay = allocate(reals);
  const az = allocate(reals);
  const sample = allocate((<usize>SAMPLES) << 4);
  const counts = allocate((<usize>BINS) << 2);
  if (write) {
    w.ids = ids;
    w.x = x;
    w.y = y;
    w.z = z;
    w.s = s;
    w.ax = ax;
    w.ay = ay;
    w.az = az;
    w.sample = sample;
    w.counts = counts;
  }
  if (nodeCapacity > 0) layOutTree(w, capacity, nodeCapacity, write);
  return cursor;
}

function layOutTree(w: NBody, capacity: i32, nodeCapacity: i32, write: bool): void {
  const reals = slotBytes(capacity);
  const words = (<usize>(capacity + 64)) << 2;
  const order = allocate(words);
  const px = allocate(reals);
  const py = allocate(reals);
  const pz = allocate(reals);
  const ps = allocate(reals);
  const keys = allocate((<usize>(capacity + 64)) << 3);
  const spareKeys = allocate((<usize>(capacity + 64)) << 3);
  const spareOrder = allocate(words);
  const nodes = allocate(<usize>nodeCapacity * NODE_BYTES);
  const links = allocate(<usize>nodeCapacity * LINK_BYTES);
  const sums = allocate(<usize>nodeCapacity * SUM_BYTES);
  const groups = allocate((<usize>nodeCapacity) << 3);
  const groupFields = allocate(<usize>nodeCapacity * sizeof<real>());
  const cells = allocate((<usize>nodeCapacity) << 2);
  const points = allocate((<usize>nodeCapacity) << 2);
  const ranges = allocate((<usize>nodeCapacity) << 3);
  if (!write) return;
  w.order = order;
  w.px = px;
  w.py = py;
  w.pz = pz;
  w.ps = ps;
  w.keys = keys;
  w.spareKeys = spareKeys;
  w.spareOrder = spareOrder;
  w.nodes = nodes;
  w.links = links;
  w.sums = sums;
  w.groups = groups;
  w.groupFields = groupFields;
  w.cells = cells;
  w.points = points;
  w.ranges = ranges;
}

// Node capacity for `capacity` bodies; when the nodes run out, leaves stay larger.
function nodesFor(capacity: i32): i32 {
  return (capacity >> 1) + (capacity >> 3) + 256;
}

// Returns the bytes for `capacity` bodies.
export function nBodyBytes(capacity: i32, hasTree: i32): usize {
  return layOut(changetype<NBody>(0), 0, capacity, hasTree != 0 ? nodesFor(capacity) : 0, false) + 64;
}

// Initialises fresh memory at `w`.
export function nBodyBegin(w: usize, capacity: i32, hasTree: i32): void {
  const work = changetype<NBody>(w);
  const nodeCapacity = hasTree != 0 ? nodesFor(capacity) : 0;
  work.capacity = capacity;
  work.hasTree = hasTree;
  work.nodeCapacity = nodeCapacity;
  work.length = 1;
  work.strength = 1;
  layOut(work, w, capacity, nodeCapacity, true);
}
