// Broad phase for discs: the pairs of bodies closer than REACH times the sum of their radii.
import { Columns, columns, get, put } from '../../columns';
import { add, at, mul, splat, sub } from '../../lanes';
import { emit, MOST_CONTACTS, MOST_TESTS } from '../emit';
import { chooseGrid, countBuckets, nameBuckets } from '../grid';
import { ContactTable, REACH, contactTable, putWord, word } from '../table';

// A body in the grid, 16 bytes in f32 so that a cache line holds four.
@unmanaged
class Disc {
  x: real;
  y: real;
  radius: real;
  row: i32;
}

// A whole number of reals, as src/collision/contact-table.ts reckons.
const SIZE: usize = (offsetof<Disc>() + sizeof<real>() - 1) & ~(sizeof<real>() - 1);

// @ts-ignore: decorator
@inline function disc(t: ContactTable, i: i32): Disc {
  return changetype<Disc>(t.packed + <usize>i * SIZE);
}

// Finds the pairs among the `count` bodies in rows [0, rows) into the raw list.
export function findPairs2d(rows: i32, count: i32): void {
  const c = columns();
  const t = contactTable();
  chooseGrid(c, t, rows, count, 2);
  fill(c, t, rows);
  for (let i = 0; i < t.gridCount; i++) {
    const bucket = word(t.sortedBucket, i);
    const above = (bucket + t.stride - 1) & (t.buckets - 1);
    if (bucket + 3 > t.buckets || above + 3 > t.buckets) {
      scanWrapped(c, t, i, bucket);
      continue;
    }
    const found = t.count;
    const left = scan(c, t, i, i + 1, word(t.starts, bucket + 2), MOST_TESTS, found);
    scan(c, t, i, word(t.starts, above), word(t.starts, above + 3), left, found);
  }
  for (let l = 0; l < t.largeCount; l++) scanLarge(c, t, l);
}

// Sorts the bodies into buckets, whole records first, which takes one line of the cache each, then as columns. Rows
// ascend within a bucket because they are placed in order.
function fill(c: Columns, t: ContactTable, rows: i32): void {
  countBuckets(c, t, rows);
  for (let row = 0; row < rows; row++) {
    const bucket = word(t.rowWords, row);
    if (bucket < 0) continue;
    const cursor = t.starts + ((<usize>bucket) << 2) + 4;
    const place = load<i32>(cursor);
    store<i32>(cursor, place + 1);
    const to = disc(t, place);
    to.x = get(c.positionX, row);
    to.y = get(c.positionY, row);
    to.radius = get(c.radius, row);
    to.row = row;
  }
  for (let i = 0; i < t.gridCount; i++) {
    const from = disc(t, i);
    put(t.sortedX, i, from.x);
    put(t.sortedY, i, from.y);
    put(t.sortedRadius, i, from.radius);
  }
  nameBuckets(t);
}

// Tests disc i against the discs [first, last) and returns how many tests are left of `tests`. `found` is the number of
// contacts before this body's first. Four at a time: most ranges are no longer, so that no branch is hard to foresee.
// @ts-ignore: decorator
@inline function scan(c: Columns, t: ContactTable, i: i32, first: i32, last: i32, tests: i32, found: i32): i32 {
  const end = first + (t.count < t.capacity ? min<i32>(last - first, tests) : 0);
  if (end != last) t.lost += last - end;
  const x = splat(get(t.sortedX, i));
  const y = splat(get(t.sortedY, i));
  const radius = splat(get(t.sortedRadius, i));
  // The first four without asking whether there are any.
  let j = first;
  do {
    let near = nearby(t, j, x, y, radius);
    if (sizeof<real>() == 8) near |= nearby(t, j + 2, x, y, radius) << 2;
    near &= 15 >> min<i32>(4, max<i32>(0, 4 - (end - j)));
    if (near != 0 && !keep(c, t, i, j, near, found)) {
      t.lost += max<i32>(0, end - j - 4);
      break;
    }
    j += 4;
  } while (j < end);
  return tests - (end - first);
}

// The discs from j, one bit a lane, that come near.
// @ts-ignore: decorator
@inline function nearby(t: ContactTable, j: i32, x: v128, y: v128, radius: v128): i32 {
  const dx = sub(v128.load(t.sortedX + at(j)), x);
  const dy = sub(v128.load(t.sortedY + at(j)), y);
  const reach = mul(add(v128.load(t.sortedRadius + at(j)), radius), splat(REACH));
  const near = v128.lt<real>(add(mul(dx, dx), mul(dy, dy)), mul(reach, reach));
  return sizeof<real>() == 4 ? i32x4.bitmask(near) : i64x2.bitmask(near);
}

// Adds the pairs of disc i and the discs j + k for the bits k of `near`; false when that was enough for one body.
function keep(c: Columns, t: ContactTable, i: i32, j: i32, near: i32, found: i32): bool {
  const row = disc(t, i).row;
  for (; near != 0; near &= near - 1) emit(c, t, row, disc(t, j + ctz(near)).row);
  return t.count - found < MOST_CONTACTS;
}

// The same where the table of buckets ends among the neighbours.
function scanWrapped(c: Columns, t: ContactTable, i: i32, bucket: i32): void {
  const mask = t.buckets - 1;
  const found = t.count;
  let tests = scan(c, t, i, i + 1, word(t.starts, bucket + 1), MOST_TESTS, found);
  for (let k = 0; k < 4; k++) {
    const next = (k == 0 ? bucket + 1 : bucket + t.stride - 2 + k) & mask;
    tests = scan(c, t, i, word(t.starts, next), word(t.starts, next + 1), tests, found);
  }
}

// A body too large for the grid, against everything in it and against the large ones after it.
function scanLarge(c: Columns, t: ContactTable, l: i32): void {
  const row = word(t.large, l);
  const x = get(c.positionX, row);
  const y = get(c.positionY, row);
  const radius = get(c.radius, row);
  for (let j = 0; j < t.gridCount; j++) {
    const other = disc(t, j);
    const dx = other.x - x;
    const dy = other.y - y;
    const reach = (other.radius + radius) * REACH;
    if (dx * dx + dy * dy < reach * reach) emit(c, t, row, other.row);
  }
  for (let m = l + 1; m < t.largeCount; m++) {
    const other = word(t.large, m);
    const dx = get(c.positionX, other) - x;
    const dy = get(c.positionY, other) - y;
    const reach = (get(c.radius, other) + radius) * REACH;
    if (dx * dx + dy * dy < reach * reach) emit(c, t, row, other);
  }
}
