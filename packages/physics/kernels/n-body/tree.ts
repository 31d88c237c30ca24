// The tree: cells of the Morton order, depth first. A node's subtree is the run of nodes up to its `next` link, so a
// walk is a loop and needs no stack. Levels at which all bodies of a cell lie in one child are left out, so the tree of
// a cluster is no deeper than its bodies make it. A cell too small for the keys gets keys of its own; bodies at one place
// share one leaf, however many they are.
import { moments } from './moments';
import { extentOf, sortBodies, sortWithin } from './morton';
import { LINK_BYTES, NBody, coincident2 } from './workspace';

// Bodies up to which a cell is not split.
const BUCKET: i32 = 16;
// Bodies that share one walk, at most.
const GROUP: i32 = 64;

// @ts-ignore: decorator
@inline function keyAt(w: NBody, place: i32): u64 {
  return load<u64>(w.keys + ((<usize>place) << 3));
}

// The first place after `first` whose key differs at or above the digit at `shift`.
function endOfCell(w: NBody, first: i32, last: i32, shift: i32): i32 {
  const cell = keyAt(w, first) >> shift;
  let low = first + 1;
  let high = last;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (keyAt(w, middle) >> shift == cell) low = middle + 1;
    else high = middle;
  }
  return low;
}

function addGroup(w: NBody, first: i32, last: i32): void {
  // Bodies at one place come in a leaf of any size.
  for (let from = first; from < last; from += GROUP) {
    const at = w.groups + ((<usize>w.groupCount) << 3);
    w.groupCount++;
    store<i32>(at, from);
    store<i32>(at, min(from + GROUP, last), 4);
  }
}

// Splits the cell of places [first, last) and all below it. `grouped`: its bodies belong to a group already.
function split(w: NBody, first: i32, last: i32, bitsPerLevel: i32, grouped: bool, level: i32): void {
  const node = w.nodeCount++;
  const link = w.links + <usize>node * LINK_BYTES;
  store<i32>(link, first, 4);
  store<i32>(link, last, 8);
  let atOnePlace = false;
  let differing = keyAt(w, first) ^ keyAt(w, last - 1);
  if (last - first > BUCKET && differing == 0) {
    // The keys are at their end: new ones for the cell's own extent, or bodies at one place.
    const extent = extentOf(w, first, last);
    atOnePlace = extent * extent <= coincident2();
    if (!atOnePlace) {
      sortWithin(w, first, last, bitsPerLevel);
      differing = keyAt(w, first) ^ keyAt(w, last - 1);
    }
  }
  store<i32>(link, i32(atOnePlace), 12);
  const full = w.nodeCount + 8 + (level << 3) > w.nodeCapacity;
  if (last - first > BUCKET && differing != 0 && !full) {
    if (level > w.deepest) w.deepest = level;
    const top = 63 - <i32>clz<u64>(differing);
    const shift = top - (top % bitsPerLevel);
    let groupFirst = first;
    let from = first;
    while (from < last) {
      const to = endOfCell(w, from, last, shift);
      const small = to - from <= GROUP;
      if (!grouped && (!small || to - groupFirst > GROUP)) {
        if (from > groupFirst) addGroup(w, groupFirst, from);
        groupFirst = small ? from : to;
      }
      split(w, from, to, bitsPerLevel, grouped || small, level + 1);
      from = to;
    }
    if (!grouped && last > groupFirst) addGroup(w, groupFirst, last);
  } else if (!grouped) {
    addGroup(w, first, last);
  }
  store<i32>(link, w.nodeCount);
}

// Builds the tree of the packed bodies. `factor` scales second moments: 3 for the law 1/r², 2 for 1/r.
export function buildTree(w: NBody, dimensions: i32, factor: f64): void {
  sortBodies(w, dimensions);
  w.nodeCount = 0;
  w.groupCount = 0;
  w.deepest = 0;
  split(w, 0, w.bodies, dimensions, w.bodies <= GROUP, 0);
  if (w.bodies <= GROUP) addGroup(w, 0, w.bodies);
  moments(w, factor);
  w.treeValid = 1;
}
