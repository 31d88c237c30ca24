// Morton keys of the packed bodies and a radix sort by them: bodies near in space become near in memory, and every cell
// of a quadtree or octree is one contiguous range. 21 bits per axis in 3D, 32 in 2D (Morton 1966).
import { get, put } from '../memory/columns';
import { NBody } from './workspace';

// Spreads 21 bits to every third bit.
// @ts-ignore: decorator
@inline function spread3(value: u64): u64 {
  let v = value & 0x1fffff;
  v = (v | (v << 32)) & 0x1f00000000ffff;
  v = (v | (v << 16)) & 0x1f0000ff0000ff;
  v = (v | (v << 8)) & 0x100f00f00f00f00f;
  v = (v | (v << 4)) & 0x10c30c30c30c30c3;
  return (v | (v << 2)) & 0x1249249249249249;
}

// Spreads 32 bits to every second bit.
// @ts-ignore: decorator
@inline function spread2(value: u64): u64 {
  let v = value & 0xffffffff;
  v = (v | (v << 16)) & 0xffff0000ffff;
  v = (v | (v << 8)) & 0xff00ff00ff00ff;
  v = (v | (v << 4)) & 0xf0f0f0f0f0f0f0f;
  v = (v | (v << 2)) & 0x3333333333333333;
  return (v | (v << 1)) & 0x5555555555555555;
}

// Returns the cell index of an offset from the root's corner.
// @ts-ignore: decorator
@inline function cellOf(offset: f64, perLength: f64, last: f64): u64 {
  return <u64>max<f64>(0, min<f64>(last, offset * perLength));
}

let lowX: f64 = 0;
let lowY: f64 = 0;
let lowZ: f64 = 0;

// Writes the keys of positions [first, last) in a root cell of the given side at the current corner.
function writeKeys(w: NBody, first: i32, last: i32, dimensions: i32, side: f64): void {
  const cells: f64 = dimensions == 3 ? 2097152 : 4294967296;
  const perLength = cells / side;
  for (let position = first; position < last; position++) {
    const x = cellOf(<f64>get(w.px, position) - lowX, perLength, cells - 1);
    const y = cellOf(<f64>get(w.py, position) - lowY, perLength, cells - 1);
    const z = cellOf(<f64>get(w.pz, position) - lowZ, perLength, cells - 1);
    const key = dimensions == 3 ? (spread3(z) << 2) | (spread3(y) << 1) | spread3(x) : (spread2(y) << 1) | spread2(x);
    store<u64>(w.keys + ((<usize>position) << 3), key);
  }
}

// Six passes of this many bits cover 64 bits, and the counts stay in the first-level cache.
const DIGIT_BITS: i32 = 11;
const DIGIT_COUNT: i32 = 1 << DIGIT_BITS;

// One pass of a least-significant-digit radix sort of positions [first, last). It is stable, so equal keys stay in
// ascending slot order. Returns whether anything moved; the result is then in the spare arrays.
function sortPass(w: NBody, first: i32, last: i32, shift: i32): bool {
  const counts = w.counts;
  const mask: u64 = DIGIT_COUNT - 1;
  memory.fill(counts, 0, (<usize>DIGIT_COUNT) << 2);
  for (let i = first; i < last; i++) {
    const at = counts + ((<usize>((load<u64>(w.keys + ((<usize>i) << 3)) >> shift) & mask)) << 2);
    store<i32>(at, load<i32>(at) + 1);
  }
  let sum = first;
  for (let digit = 0; digit < DIGIT_COUNT; digit++) {
    const at = counts + ((<usize>digit) << 2);
    const count = load<i32>(at);
    if (count == last - first) return false;
    store<i32>(at, sum);
    sum += count;
  }
  for (let i = first; i < last; i++) {
    const key = load<u64>(w.keys + ((<usize>i) << 3));
    const at = counts + ((<usize>((key >> shift) & mask)) << 2);
    const to = load<i32>(at);
    store<i32>(at, to + 1);
    store<u64>(w.spareKeys + ((<usize>to) << 3), key);
    store<i32>(w.spareOrder + ((<usize>to) << 2), load<i32>(w.order + ((<usize>i) << 2)));
  }
  return true;
}

function swapBuffers(w: NBody): void {
  const keys = w.keys;
  w.keys = w.spareKeys;
  w.spareKeys = keys;
  const order = w.order;
  w.order = w.spareOrder;
  w.spareOrder = order;
}

function sortRange(w: NBody, first: i32, last: i32): void {
  let moved = false;
  for (let shift = 0; shift < 64; shift += DIGIT_BITS) {
    if (!sortPass(w, first, last, shift)) continue;
    swapBuffers(w);
    moved = !moved;
  }
  if (!moved) return;
  // After an odd number of passes the range is in the former spare arrays and is copied back.
  swapBuffers(w);
  const from = <usize>first;
  const count = <usize>(last - first);
  memory.copy(w.keys + (from << 3), w.spareKeys + (from << 3), count << 3);
  memory.copy(w.order + (from << 2), w.spareOrder + (from << 2), count << 2);
}

function gatherRange(w: NBody, first: i32, last: i32): void {
  for (let position = first; position < last; position++) {
    const slot = load<i32>(w.order + ((<usize>position) << 2));
    put(w.px, position, get(w.x, slot));
    put(w.py, position, get(w.y, slot));
    put(w.pz, position, get(w.z, slot));
    put(w.ps, position, get(w.s, slot));
  }
}

// Sorts the bodies into Morton order.
export function sortBodies(w: NBody, dimensions: i32): void {
  const n = w.bodies;
  for (let position = 0; position < n; position++) {
    store<i32>(w.order + ((<usize>position) << 2), position < w.sources ? position : position - w.sources + w.tests);
  }
  gatherRange(w, 0, n);
  lowX = w.lowX;
  lowY = w.lowY;
  lowZ = w.lowZ;
  writeKeys(w, 0, n, dimensions, w.side);
  sortRange(w, 0, n);
  gatherRange(w, 0, n);
  // Vectors of targets may extend past the end.
  for (let position = n; position < n + 8; position++) {
    put(w.px, position, get(w.px, n - 1));
    put(w.py, position, get(w.py, n - 1));
    put(w.pz, position, get(w.pz, n - 1));
    put(w.ps, position, 0);
  }
}

// Returns the largest side of the bounding box of positions [first, last), and stores its corner.
export function extentOf(w: NBody, first: i32, last: i32): f64 {
  lowX = Infinity;
  lowY = Infinity;
  lowZ = Infinity;
  let highX: f64 = -Infinity;
  let highY: f64 = -Infinity;
  let highZ: f64 = -Infinity;
  for (let position = first; position < last; position++) {
    const x = <f64>get(w.px, position);
    const y = <f64>get(w.py, position);
    const z = <f64>get(w.pz, position);
    lowX = min<f64>(lowX, x);
    lowY = min<f64>(lowY, y);
    lowZ = min<f64>(lowZ, z);
    highX = max<f64>(highX, x);
    highY = max<f64>(highY, y);
    highZ = max<f64>(highZ, z);
  }
  return max<f64>(highX - lowX, max<f64>(highY - lowY, highZ - lowZ));
}

// Sorts positions [first, last) by separate keys, because the cell is too small for the keys of the root.
export function sortWithin(w: NBody, first: i32, last: i32, dimensions: i32): void {
  const side = extentOf(w, first, last);
  // The farthest body is in the last cell, not beyond it.
  writeKeys(w, first, last, dimensions, side);
  sortRange(w, first, last);
  gatherRange(w, first, last);
}
