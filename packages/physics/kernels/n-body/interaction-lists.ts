// Interaction lists: the cells and bodies that act on a group, from one traversal for all bodies of the group.
//
// A cell is accepted if it does not contain the group, the group is beyond most of its radius, and its neglected moment
// is small against the field: with B = (sum |s| x²) b, b the distance of the farthest body, the octupole force is of the
// order B/d⁵ (1/r²) or B/d⁴ (1/r), with d the distance from the cell's centre to the nearest point of the group's box.
// It must be at most `tolerance` times the field scale of the group (Salmon & Warren, J. Comput. Phys. 111, 136, 1994:
// an absolute bound per cell reaches the same error with fewer cells than a fixed opening angle). Cost: one visit per
// cell.
import { get } from '../memory/columns';
import { LINK_BYTES, NBody, NEAR2, NODE_BYTES, REAL, SIZE } from './workspace';

// The current group: its positions [groupFirst, groupLast) in tree order, and its bounding box.
let groupFirst: i32 = 0;
let groupLast: i32 = 0;
let boxX: real = 0;
let boxY: real = 0;
let boxZ: real = 0;
let halfX: real = 0;
let halfY: real = 0;
let halfZ: real = 0;

// Makes positions [first, last) the current group, and computes its bounding box as centre and half sides.
export function boundGroup(w: NBody, first: i32, last: i32): void {
  groupFirst = first;
  groupLast = last;
  let lowX = get(w.px, first);
  let lowY = get(w.py, first);
  let lowZ = get(w.pz, first);
  let highX = lowX;
  let highY = lowY;
  let highZ = lowZ;
  for (let i = first + 1; i < last; i++) {
    const x = get(w.px, i);
    const y = get(w.py, i);
    const z = get(w.pz, i);
    lowX = min<real>(lowX, x);
    lowY = min<real>(lowY, y);
    lowZ = min<real>(lowZ, z);
    highX = max<real>(highX, x);
    highY = max<real>(highY, y);
    highZ = max<real>(highZ, z);
  }
  const half: real = 0.5;
  boxX = half * (lowX + highX);
  boxY = half * (lowY + highY);
  boxZ = half * (lowZ + highZ);
  halfX = half * (highX - lowX);
  halfY = half * (highY - lowY);
  halfZ = half * (highZ - lowZ);
}

// Whether a cell contains the current group. Its moments do not approximate the group's own bodies, even if these are far
// from its centre, as both of two distant clusters are.
// @ts-ignore: decorator
@inline function containsGroup(link: usize): bool {
  return load<i32>(link, 4) <= groupFirst && groupLast <= load<i32>(link, 8);
}

// Returns the magnitude of the field at the centre of the current group, from a coarse traversal. The contribution of a
// cell is limited to its value at the box's corners, so that a close pair near the centre does not dominate, and to that
// at the softening length: without it a clump much smaller than that length has thousands of times its field, the cells
// that act on it are hardly opened, and the tolerance that makes up for it opens those of all other groups.
export function fieldScale(w: NBody, inverseSquare: bool): real {
  let ax: f64 = 0;
  let ay: f64 = 0;
  let az: f64 = 0;
  const corner2 = <f64>(halfX * halfX + halfY * halfY + halfZ * halfZ);
  const nearest2 = max<f64>(corner2, w.softening2);
  for (let node = 0; node < w.nodeCount; ) {
    const p = w.nodes + <usize>node * NODE_BYTES;
    const link = w.links + <usize>node * LINK_BYTES;
    const next = load<i32>(link);
    const dx = <f64>(load<real>(p) - boxX);
    const dy = <f64>(load<real>(p + REAL) - boxY);
    const dz = <f64>(load<real>(p + 2 * REAL) - boxZ);
    const d2 = dx * dx + dy * dy + dz * dz;
    const near2 = <f64>load<real>(p + NEAR2);
    const isLeaf = next == node + 1;
    if (isLeaf && corner2 == 0 && containsGroup(link)) {
      // A body alone, or several in one place, have no field there. The centre of their cell may be rounded away from them.
      node = next;
    } else if (isLeaf || (d2 > near2 && !containsGroup(link))) {
      const u = max<f64>(d2 + near2, nearest2);
      const k = <f64>load<real>(p + 3 * REAL) / (inverseSquare ? u * sqrt<f64>(u) : u);
      ax += k * dx;
      ay += k * dy;
      az += k * dz;
      node = next;
    } else {
      node++;
    }
  }
  return <real>sqrt<f64>(ax * ax + ay * ay + az * az);
}

// Fills the lists of the current group: node addresses in `cells` and, for coincident bodies, in `points`; index ranges
// of bodies in `ranges`.
export function listInteractions(w: NBody, allowed: real, inverseSquare: bool): void {
  const nodeCount = w.nodeCount;
  const nodes = w.nodes;
  const links = w.links;
  const zero: real = 0;
  let cell = w.cells;
  let point = w.points;
  let range = w.ranges;
  let lastEnd = -1;
  let pairs = 0;
  for (let node = 0; node < nodeCount; ) {
    const p = nodes + <usize>node * NODE_BYTES;
    const link = links + <usize>node * LINK_BYTES;
    const size = load<real>(p + SIZE);
    const next = load<i32>(link);
    const dx = max<real>(abs<real>(load<real>(p) - boxX) - halfX, zero);
    const dy = max<real>(abs<real>(load<real>(p + REAL) - boxY) - halfY, zero);
    const dz = max<real>(abs<real>(load<real>(p + 2 * REAL) - boxZ) - halfZ, zero);
    const d2 = dx * dx + dy * dy + dz * dz;
    const d4 = d2 * d2;
    const isAccurate = d2 > load<real>(p + NEAR2) && size <= allowed * (inverseSquare ? d4 * sqrt<real>(d2) : d4);
    if (isAccurate && !containsGroup(link)) {
      if (size >= 0) {
        store<u32>(cell, <u32>p);
        cell += 4;
      }
      node = next;
    } else if (load<i32>(link, 12)) {
      store<u32>(point, <u32>p);
      point += 4;
      pairs++;
      node = next;
    } else if (next == node + 1) {
      const first = load<i32>(link, 4);
      const last = load<i32>(link, 8);
      if (first == lastEnd) {
        store<i32>(range - 8, last, 4);
      } else {
        store<i32>(range, first);
        store<i32>(range, last, 4);
        range += 8;
      }
      lastEnd = last;
      pairs += last - first;
      node = next;
    } else {
      node++;
    }
  }
  w.cellCount = <i32>((cell - w.cells) >> 2);
  w.pointCount = <i32>((point - w.points) >> 2);
  w.rangeCount = <i32>((range - w.ranges) >> 3);
  w.listedBodies = pairs;
}
