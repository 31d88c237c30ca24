// Broad phase for discs and balls: the pairs of bodies closer than REACH times the sum of their radii.
//
// Bodies lie in the order of their cells, as columns. Each is tested against those after it in its own cell and against
// half of the neighbouring cells: the next in x, and of the rows of three above it one in 2D and four in 3D. Those too
// large for the grid come last, and are tested against all before them.
import { Columns, columns, get, put } from '../memory/columns';
import { add, at, mul, splat, sub } from '../memory/lanes';
import { chooseGrid, countBuckets } from './grid';
import { ContactTable, REACH, contactTable, putWord, word } from './table';

// A heap of bodies in one place has a number of pairs that grows with its square: candidates looked at for one body, and
// contacts kept for it as the one that found them. What is left out is counted in `lost`, never silent.
const MOST_TESTS: i32 = 4096;
const MOST_CONTACTS: i32 = 128;

// The number of contacts at which the body whose neighbours are looked at has enough.
let enough: i32 = 0;

// Finds the pairs among the `count` bodies in rows [0, rows) into the raw list, in `dimensions` 2 or 3.
export function findPairs(rows: i32, count: i32, dimensions: i32): void {
  const c = columns();
  const t = contactTable();
  chooseGrid(c, t, rows, count, dimensions);
  countBuckets(c, t, rows);
  sortBodies(c, t, rows);
  for (let i = 0; i < t.gridCount; i++) findNeighbours(c, t, i, dimensions == 2 ? 2 : 5);
  for (let i = t.gridCount; i < t.gridCount + t.largeCount; i++) findNeighbours(c, t, i, 0);
}

// Finds the pairs of body i with those in so many `groups` of neighbouring cells; of a large body, which has none, with
// all before it.
function findNeighbours(c: Columns, t: ContactTable, i: i32, groups: i32): void {
  const buckets = t.buckets;
  const bucket = word(t.sortedBucket, i);
  let tests = groups == 0 ? i32.MAX_VALUE : MOST_TESTS;
  enough = groups == 0 ? i32.MAX_VALUE : t.count + MOST_CONTACTS;
  const x = splat(get(t.sortedX, i));
  const y = splat(get(t.sortedY, i));
  const z = splat(t.layer == 0 ? <real>0 : get(t.sortedZ, i));
  const radius = splat(get(t.sortedRadius, i));
  let group = 0;
  let start = groups == 0 ? 0 : i + 1;
  let end = bucket + 2;
  while (true) {
    // The cells of a group follow each other, but for where the table of buckets ends.
    const last = groups == 0 ? i : word(t.starts, min<i32>(end, buckets));
    const limit = start + (t.count < min<i32>(t.capacity, enough) ? min<i32>(last - start, tests) : 0);
    if (limit != last) t.lost += last - limit;
    tests -= limit - start;
    // Four at a time: most groups are no larger, so that no branch is hard to foresee; the first four without asking
    // whether there are any.
    let j = start;
    do {
      let near = nearby(t, j, x, y, z, radius);
      if (sizeof<real>() == 8) near |= nearby(t, j + 2, x, y, z, radius) << 2;
      near &= 15 >> min<i32>(4, max<i32>(0, 4 - (limit - j)));
      if (near != 0 && !keep(c, t, i, j, near)) {
        t.lost += max<i32>(0, limit - j - 4);
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
    // Of three cells each: above; and in the next layer below, level and above.
    const middle = bucket + (group == 1 ? t.stride : t.layer + (group - 3) * t.stride);
    const first = (middle - 1) & (buckets - 1);
    start = word(t.starts, first);
    end = first + 3;
  }
}

// Sorts the bodies into buckets. Rows ascend within a bucket because they are placed in order.
function sortBodies(c: Columns, t: ContactTable, rows: i32): void {
  let end = t.gridCount;
  for (let row = 0; row < rows; row++) {
    const bucket = word(t.rowWords, row);
    if (bucket == -1) continue;
    let place = end;
    if (bucket >= 0) {
      place = word(t.starts, bucket + 1);
      putWord(t.starts, bucket + 1, place + 1);
    } else end++;
    putWord(t.sortedRow, place, row);
  }
  for (let i = 0; i < end; i++) {
    const row = word(t.sortedRow, i);
    putWord(t.sortedBucket, i, word(t.rowWords, row));
    put(t.sortedX, i, get(c.positionX, row));
    put(t.sortedY, i, get(c.positionY, row));
    if (t.layer != 0) put(t.sortedZ, i, get(c.positionZ, row));
    put(t.sortedRadius, i, get(c.radius, row));
  }
}

// The bodies from j, one bit a lane, that come near.
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
  const reach = mul(add(v128.load(t.sortedRadius + o), radius), splat(REACH));
  const near = v128.lt<real>(square, mul(reach, reach));
  return sizeof<real>() == 4 ? i32x4.bitmask(near) : i64x2.bitmask(near);
}

// Adds the pairs of body i and the bodies j + k for the bits k of `near`, smaller row first, unless neither of the two
// can move. False when that was enough for one body.
function keep(c: Columns, t: ContactTable, i: i32, j: i32, near: i32): bool {
  const p = word(t.sortedRow, i);
  for (; near != 0; near &= near - 1) {
    const q = word(t.sortedRow, j + ctz(near));
    if (!(get(c.mass, p) > 0 || get(c.mass, q) > 0)) continue;
    const k = t.count;
    if (k >= t.capacity) {
      t.lost++;
      continue;
    }
    t.count = k + 1;
    putWord(t.slotA, k, min<i32>(p, q));
    putWord(t.slotB, k, max<i32>(p, q));
  }
  return t.count < enough;
}
