// The tree: cells of the Morton order, depth first. A node's subtree extends to its `next` link, so a traversal is a
// loop without a stack. Levels at which all bodies of a cell are in one child are omitted, so the tree of a cluster is
// no deeper than its bodies require. A cell too small for the root's keys gets separate keys; coincident bodies share
// one leaf of any size.
import { moments } from './moments';
import { extentOf, sortBodies, sortWithin } from './morton';
import { LINK_BYTES, NBody, coincident2 } from './workspace';

// Cells up to this many bodies are not split.
const LEAF_SIZE: i32 = 16;
// Maximum number of bodies that share one traversal.
const GROUP_SIZE: i32 = 64;

// @ts-ignore: decorator
@inline function keyAt(w: NBody, position: i32): u64 {
  return load<u64>(w.keys + ((<usize>position) << 3));
}

// Returns the first position after `first` whose key differs at or above the digit at `shift`.
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
  // Coincident bodies form a leaf of any size.
  for (let from = first; from < last; from += GROUP_SIZE) {
    const at = w.groups + ((<usize>w.groupCount) << 3);
    w.groupCount++;
    store<i32>(at, from);
    store<i32>(at, min(from + GROUP_SIZE, last), 4);
  }
}

// Splits the cell of positions [first, last) recursively. `grouped` means that its bodies already belong to a group.
function split(w: NBody, first: i32, last: i32, bitsPerLevel: i32, grouped: bool, level: i32): void {
  const node = w.nodeCount++;
  const link = w.links + <usize>node * LINK_BYTES;
  store<i32>(link, first, 4);
  store<i32>(link, last, 8);
  let coincident = false;
  let differing = keyAt(w, first) ^ keyAt(w, last - 1);
  if (last - first > LEAF_SIZE && differing == 0) {
    // The key bits are used up: the cell gets new keys for its extent, or its bodies coincide.
    const extent = extentOf(w, first, last);
    coincident = extent * extent <= coincident2();
    if (!coincident) {
      sortWithin(w, first, last, bitsPerLevel);
      differing = keyAt(w, first) ^ keyAt(w, last - 1);
    }
  }
  store<i32>(link, i32(coincident), 12);
  const full = w.nodeCount + 8 + (level << 3) > w.nodeCapacity;
  if (last - first > LEAF_SIZE && differing != 0 && !full) {
    if (level > w.maxDepth) w.maxDepth = level;
    const top = 63 - <i32>clz<u64>(differing);
    const shift = top - (top % bitsPerLevel);
    let groupFirst = first;
    let from = first;
    while (from < last) {
      const to = endOfCell(w, from, last, shift);
      const small = to - from <= GROUP_SIZE;
      if (!grouped && (!small || to - groupFirst > GROUP_SIZE)) {
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
  w.maxDepth = 0;
  split(w, 0, w.bodies, dimensions, w.bodies <= GROUP_SIZE, 0);
  if (w.bodies <= GROUP_SIZE) addGroup(w, 0, w.bodies);
  moments(w, factor);
  w.treeValid = 1;
}
