// The working memory of one mutual force: bodies packed by slot, the same bodies in tree order, the tree, the lists of
// one group, results. Lengths are in units of `length` and strengths in units of `strength`, powers of two near the
// extent of the system and the strongest body: exact to scale by, and no unit system overflows the range of f32.
import { BINS } from './approximate-median';

@unmanaged
export class NBody {
  // Slots: bodies that pull at [0, sources), padding without strength, then test particles at [tests, end).
  capacity: i32;
  sources: i32;
  tests: i32;
  end: i32;
  // 1 where the tree and its lists have room.
  hasTree: i32;
  nodeCapacity: i32;
  ids: usize;
  x: usize;
  y: usize;
  z: usize;
  s: usize;
  // Results by slot (direct) or by place in the tree: force between the bodies that pull, else acceleration.
  ax: usize;
  ay: usize;
  az: usize;
  // Numbers of what falls into each of some bins.
  counts: usize;
  // Tree order: slot of a place, and the columns again.
  order: usize;
  px: usize;
  py: usize;
  pz: usize;
  ps: usize;
  // Sorting, free afterwards.
  keys: usize;
  spareKeys: usize;
  spareOrder: usize;
  // The tree, depth first: numbers and links of each node; groups as pairs of places; lists of the group at work.
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
  // Which part of this is up to date with the slots.
  treeValid: i32;
  resultsValid: i32;
  resultsByTree: i32;
  // The largest level at which a node was split, for the tests.
  deepest: i32;
  evaluations: i32;
  length: f64;
  strength: f64;
  // Smallest corner of the slots.
  lowX: f64;
  lowY: f64;
  lowZ: f64;
  // Softening length squared, in units of length².
  softening2: f64;
  // Distances below it drown in the rounding of the coordinates, or in the range of their seventh power.
  grain: f64;
  // What a cell may spend of the field's scale, and the error measured last.
  tolerance: f64;
  error: f64;
  // Mean square of the error as the looks so far make it; 0 before the first.
  meanSquare: f64;
  // Target-source pairs of the last evaluation.
  cellPairs: f64;
  bodyPairs: f64;
}

// @ts-ignore: decorator
@inline export const SAMPLES: i32 = 1024;

// Numbers of a node, in reals; the expansion's order is that of evaluate-3d.ts.
// @ts-ignore: decorator
@inline export const NODE_REALS: i32 = 16;
// @ts-ignore: decorator
@inline export const NODE_BYTES: usize = <usize>NODE_REALS * sizeof<real>();
// Links of a node: the node after its subtree, first and last place of its bodies, and 1 if they are all at one place.
// @ts-ignore: decorator
@inline export const LINK_BYTES: usize = 16;
// What parents need of a node besides: absolute strength, sum |s| x², distance of its farthest body; f64 each.
// @ts-ignore: decorator
@inline export const SUM_BYTES: usize = 24;

// Offsets of a node's numbers: centre, strength, second moments times the law's factor, half their trace, dipole,
// the size that opens it, and the square of the distance within which its expansion means nothing.
// @ts-ignore: decorator
@inline export const REAL: usize = sizeof<real>();
// @ts-ignore: decorator
@inline export const SIZE: usize = 14 * REAL;
// @ts-ignore: decorator
@inline export const NEAR2: usize = 15 * REAL;

// Square of the distance below which bodies count as being at one place, in units of the extent: its 3/2 power is
// still a normal number.
// @ts-ignore: decorator
@inline export function coincident2(): f64 {
  // In f32 its power 3/2 must not make the pull of a million bodies in one place overflow.
  return sizeof<real>() == 4 ? 1e-20 : 1e-200;
}

let cursor: usize = 0;
let taken: i32 = 0;

// Arrays start at staggered places of a page, so that walking several in step does not fight over cache sets.
function take(bytes: usize): usize {
  cursor = ((cursor + 63) & ~63) + <usize>((taken++ & 7) * 320);
  const start = cursor;
  cursor += bytes;
  return start;
}

function slotBytes(count: i32): usize {
  return <usize>(count + 64) * sizeof<real>();
}

// Lays the arrays out behind `w` for `capacity` bodies and returns the end; nothing is read or written besides the
// addresses when `measure` is 0. A tree of `nodeCapacity` nodes, or none.
function layOut(w: NBody, base: usize, capacity: i32, nodeCapacity: i32, write: bool): usize {
  cursor = base + offsetof<NBody>();
  taken = 0;
  const reals = slotBytes(capacity);
  const words = (<usize>(capacity + 64)) << 2;
  const ids = take(words);
  const x = take(reals);
  const y = take(reals);
  const z = take(reals);
  const s = take(reals);
  const ax = take(reals);
  const ay = take(reals);
  const az = take(reals);
  const sample = take((<usize>SAMPLES) << 4);
  const counts = take((<usize>BINS) << 2);
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
  const order = take(words);
  const px = take(reals);
  const py = take(reals);
  const pz = take(reals);
  const ps = take(reals);
  const keys = take((<usize>(capacity + 64)) << 3);
  const spareKeys = take((<usize>(capacity + 64)) << 3);
  const spareOrder = take(words);
  const nodes = take(<usize>nodeCapacity * NODE_BYTES);
  const links = take(<usize>nodeCapacity * LINK_BYTES);
  const sums = take(<usize>nodeCapacity * SUM_BYTES);
  const groups = take((<usize>nodeCapacity) << 3);
  const groupFields = take(<usize>nodeCapacity * sizeof<real>());
  const cells = take((<usize>nodeCapacity) << 2);
  const points = take((<usize>nodeCapacity) << 2);
  const ranges = take((<usize>nodeCapacity) << 3);
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

// Most nodes a tree of `capacity` bodies gets; where they run out, leaves stay larger.
function nodesFor(capacity: i32): i32 {
  return (capacity >> 1) + (capacity >> 3) + 256;
}

// Bytes for `capacity` bodies.
export function nBodyBytes(capacity: i32, hasTree: i32): usize {
  return layOut(changetype<NBody>(0), 0, capacity, hasTree != 0 ? nodesFor(capacity) : 0, false) + 64;
}

// Prepares fresh memory at `w`.
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
