// Broad phase for discs and balls: finds the pairs of bodies closer than CONTACT_MARGIN times the sum of their radii.
//
// Bodies are stored as columns in the order of their cells. Each body is tested against the bodies after it in its own
// cell and against half of the adjacent cells: the next in x, and rows of three cells, one row in 2D and four in 3D.
// Bodies too large for the grid come last and are tested against all bodies before them.
import { Columns, columns, get, put } from '../memory/columns';
import { add, at, mul, splat, sub } from '../memory/lanes';
import { chooseGrid, countBuckets } from './grid';
import { ContactTable, CONTACT_MARGIN, contactTable, putWord, word } from './table';

// Many bodies at one point have a number of pairs that grows quadratically. These limits apply to the candidates tested
// for one body and to the contacts found from it. Dropped candidates are counted in `droppedCount`.
const MAX_TESTS_PER_BODY: i32 = 4096;
const MAX_CONTACTS_PER_BODY: i32 = 128;

// The contact count at which the search for the current body stops.
let contactLimit: i32 = 0;

// Writes the pairs among the bodies in rows [0, rows) to the unsorted list, in 2 or 3 `dimensions`.
export function findPairs(rows: i32, dimensions: i32): void {
  const c = columns();
  const t = contactTable();
  chooseGrid(c, t, rows, dimensions);
  countBuckets(c, t, rows);
  sortBodies(c, t, rows);
  for (let i = 0; i < t.gridCount; i++) findNeighbours(c, t, i, dimensions == 2 ? 2 : 5);
  for (let i = t.gridCount; i < t.gridCount + t.largeCount; i++) findNeighbours(c, t, i, 0);
}

// Finds the pairs of body i with the bodies of its `groups` groups of adjacent cells. A large body has no groups and is
// tested against all bodies before it.
function findNeighbours(c: Columns, t: ContactTable, i: i32, groups: i32): void {
  const buckets = t.buckets;
  const bucket = word(t.sortedBucket, i);
  let tests = groups == 0 ? i32.MAX_VALUE : MAX_TESTS_PER_BODY;
  contactLimit = groups == 0 ? i32.MAX_VALUE : t.count + MAX_CONTACTS_PER_BODY;
  const x = splat(get(t.sortedX, i));
  const y = splat(get(t.sortedY, i));
  const z = splat(t.layer == 0 ? <real>0 : get(t.sortedZ, i));
  const radius = splat(get(t.sortedRadius, i));
  let group = 0;
  let start = groups == 0 ? 0 : i + 1;
  let end = bucket + 2;
  while (true) {
    // The cells of a group are contiguous except where the bucket table wraps.
    const last = groups == 0 ? i : word(t.starts, min<i32>(end, buckets));
    const limit = start + (t.count < min<i32>(t.capacity, contactLimit) ? min<i32>(last - start, tests) : 0);
    if (limit != last) t.droppedCount += last - limit;
    tests -= limit - start;
    // Four bodies are tested at a time. Most groups are no larger, so the branch is predictable; the first four are
    // tested without checking whether the group is empty.
    let j = start;
    do {
      let near = nearby(t, j, x, y, z, radius);
      if (sizeof<real>() == 8) near |= nearby(t, j + 2, x, y, z, radius) << 2;
      near &= 15 >> min<i32>(4, max<i32>(0, 4 - (limit - j)));
      if (near != 0 && !addPairs(c, t, i, j, near)) {
        t.droppedCount += max<i32>(0, limit - j - 4);
        break;
      }
      j += 4;
    } while (j < limit);
    if (end > buckets && groups != 0) {
      start = 0;
      end -= buckets;
      continue;
    }
    if (++group >= groups) return;
    // Each group has three cells: above in the same layer, then below, level and above in the next layer.
    const middle = bucket + (group == 1 ? t.stride : t.layer + (group - 3) * t.stride);
    const first = (middle - 1) & (buckets - 1);
    start = word(t.starts, first);
    end = first + 3;
  }
}

// Sorts the bodies into buckets. Rows are placed in order, so they ascend within a bucket. The loops read the records through
// locals, because the compiler must assume that stores change them.
function sortBodies(c: Columns, t: ContactTable, rows: i32): void {
  const rowWords = t.rowWords;
  const starts = t.starts;
  const sortedRow = t.sortedRow;
  let end = t.gridCount;
  for (let row = 0; row < rows; row++) {
    const bucket = word(rowWords, row);
    if (bucket == -1) continue;
    let position = end;
    if (bucket >= 0) {
      position = word(starts, bucket + 1);
      putWord(starts, bucket + 1, position + 1);
    } else end++;
    putWord(sortedRow, position, row);
  }
  sortColumn(c.positionX, t.sortedX, sortedRow, end);
  sortColumn(c.positionY, t.sortedY, sortedRow, end);
  if (t.layer != 0) sortColumn(c.positionZ, t.sortedZ, sortedRow, end);
  sortColumn(c.radius, t.sortedRadius, sortedRow, end);
  const sortedBucket = t.sortedBucket;
  for (let i = 0; i < end; i++) putWord(sortedBucket, i, word(rowWords, word(sortedRow, i)));
}

function sortColumn(column: usize, sorted: usize, rows: usize, end: i32): void {
  for (let i = 0; i < end; i++) put(sorted, i, get(column, word(rows, i)));
}

// Returns a bit mask of the bodies from j that are within the contact margin.
// @ts-ignore: decorator
@inline function nearby(t: ContactTable, j: i32, x: v128, y: v128, z: v128, radius: v128): i32 {
  const o = at(j);
  const dx = sub(v128.load(t.sortedX + o), x);
  const dy = sub(v128.load(t.sortedY + o), y);
  let square = add(mul(dx, dx), mul(dy, dy));
  if (t.layer != 0) {
    const dz = sub(v128.load(t.sortedZ + o), z);
    square = add(square, mul(dz, dz));
  }
  const reach = mul(add(v128.load(t.sortedRadius + o), radius), splat(CONTACT_MARGIN));
  const near = v128.lt<real>(square, mul(reach, reach));
  return sizeof<real>() == 4 ? i32x4.bitmask(near) : i64x2.bitmask(near);
}

// Returns whether each of two bodies is on a layer of the other's mask.
// @ts-ignore: decorator
@inline function mayCollide(c: Columns, p: i32, q: i32): bool {
  return (word(c.layers, p) & word(c.mask, q)) != 0 && (word(c.layers, q) & word(c.mask, p)) != 0;
}

// Adds the pairs of body i and the bodies j + k for the bits k of `near`, smaller row first, unless both are immovable
// or their layers do not collide.
// Returns false once the body has reached its contact limit.
function addPairs(c: Columns, t: ContactTable, i: i32, j: i32, near: i32): bool {
  const p = word(t.sortedRow, i);
  for (; near != 0; near &= near - 1) {
    const q = word(t.sortedRow, j + ctz(near));
    if (!(get(c.mass, p) > 0 || get(c.mass, q) > 0) || !mayCollide(c, p, q)) continue;
    const k = t.count;
    if (k >= t.capacity) {
      t.droppedCount++;
      continue;
    }
    t.count = k + 1;
    putWord(t.slotA, k, min<i32>(p, q));
    putWord(t.slotB, k, max<i32>(p, q));
  }
  return t.count < contactLimit;
}
