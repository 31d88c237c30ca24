// Broad phase for balls: the pairs of bodies closer than REACH times the sum of their radii.
import { Columns, columns, get } from '../../columns';
import { emit, MOST_CONTACTS, MOST_TESTS } from '../emit';
import { chooseGrid, countBuckets } from '../grid';
import { ContactTable, REACH, contactTable, putWord, word } from '../table';

// A body in the grid, 20 bytes in f32.
@unmanaged
class Ball {
  x: real;
  y: real;
  z: real;
  radius: real;
  row: i32;
}

// A whole number of reals, as src/collision/contact-table.ts reckons.
const SIZE: usize = (offsetof<Ball>() + sizeof<real>() - 1) & ~(sizeof<real>() - 1);

// @ts-ignore: decorator
@inline function ball(t: ContactTable, i: i32): Ball {
  return changetype<Ball>(t.packed + <usize>i * SIZE);
}

// Finds the pairs among the `count` bodies in rows [0, rows) into the raw list.
export function findPairs3d(rows: i32, count: i32): void {
  const c = columns();
  const t = contactTable();
  chooseGrid(c, t, rows, count, 3);
  fill(c, t, rows);
  const mask = t.buckets - 1;
  for (let bucket = 0; bucket <= mask; bucket++) {
    const first = word(t.starts, bucket);
    const last = word(t.starts, bucket + 1);
    for (let i = first; i < last; i++) scanBall(c, t, i, last, bucket);
  }
  for (let l = 0; l < t.largeCount; l++) scanLarge(c, t, l);
}

// Sorts the bodies into buckets. Rows ascend within a bucket because they are placed in order.
function fill(c: Columns, t: ContactTable, rows: i32): void {
  countBuckets(c, t, rows);
  for (let row = 0; row < rows; row++) {
    const bucket = word(t.rowWords, row);
    if (bucket < 0) continue;
    const cursor = t.starts + ((<usize>bucket) << 2) + 4;
    const place = load<i32>(cursor);
    store<i32>(cursor, place + 1);
    const to = ball(t, place);
    to.x = get(c.positionX, row);
    to.y = get(c.positionY, row);
    to.z = get(c.positionZ, row);
    to.radius = get(c.radius, row);
    to.row = row;
  }
}

// Tests ball i against the balls [first, last) and returns how many tests are left of `tests`. `found` is the number of
// contacts before this body's first.
// @ts-ignore: decorator
@inline function scan(c: Columns, t: ContactTable, i: i32, first: i32, last: i32, tests: i32, found: i32): i32 {
  const body = ball(t, i);
  const x = body.x;
  const y = body.y;
  const z = body.z;
  const radius = body.radius;
  const end = first + (t.count < t.capacity ? min<i32>(last - first, tests) : 0);
  t.lost += last - end;
  for (let j = first; j < end; j++) {
    const other = ball(t, j);
    const dx = other.x - x;
    const dy = other.y - y;
    const dz = other.z - z;
    const reach = (other.radius + radius) * REACH;
    if (dx * dx + dy * dy + dz * dz < reach * reach) {
      emit(c, t, body.row, other.row);
      if (t.count - found >= MOST_CONTACTS) {
        t.lost += end - j - 1;
        break;
      }
    }
  }
  return tests - (end - first);
}

// Tests ball i, of the bucket that ends at `last`, against those after it there and in half of the 26 neighbours: the
// next cell in x, and four rows of three.
function scanBall(c: Columns, t: ContactTable, i: i32, last: i32, bucket: i32): void {
  const mask = t.buckets - 1;
  const found = t.count;
  let tests: i32;
  if (bucket < mask) {
    tests = scan(c, t, i, i + 1, word(t.starts, bucket + 2), MOST_TESTS, found);
  } else {
    tests = scan(c, t, i, i + 1, last, MOST_TESTS, found);
    tests = scan(c, t, i, 0, word(t.starts, 1), tests, found);
  }
  tests = scanRow(c, t, i, bucket + t.stride, tests, found);
  tests = scanRow(c, t, i, bucket + t.layer - t.stride, tests, found);
  tests = scanRow(c, t, i, bucket + t.layer, tests, found);
  scanRow(c, t, i, bucket + t.layer + t.stride, tests, found);
}

// Tests ball i against the cell `middle` and its neighbours in x.
function scanRow(c: Columns, t: ContactTable, i: i32, middle: i32, tests: i32, found: i32): i32 {
  const mask = t.buckets - 1;
  const first = (middle - 1) & mask;
  if (first + 2 <= mask) return scan(c, t, i, word(t.starts, first), word(t.starts, first + 3), tests, found);
  let left = tests;
  for (let k = 0; k < 3; k++) {
    const next = (first + k) & mask;
    left = scan(c, t, i, word(t.starts, next), word(t.starts, next + 1), left, found);
  }
  return left;
}

// A body too large for the grid, against everything in it and against the large ones after it.
function scanLarge(c: Columns, t: ContactTable, l: i32): void {
  const row = word(t.large, l);
  const x = get(c.positionX, row);
  const y = get(c.positionY, row);
  const z = get(c.positionZ, row);
  const radius = get(c.radius, row);
  for (let j = 0; j < t.gridCount; j++) {
    const other = ball(t, j);
    const dx = other.x - x;
    const dy = other.y - y;
    const dz = other.z - z;
    const reach = (other.radius + radius) * REACH;
    if (dx * dx + dy * dy + dz * dz < reach * reach) emit(c, t, row, other.row);
  }
  for (let m = l + 1; m < t.largeCount; m++) {
    const other = word(t.large, m);
    const dx = get(c.positionX, other) - x;
    const dy = get(c.positionY, other) - y;
    const dz = get(c.positionZ, other) - z;
    const reach = (get(c.radius, other) + radius) * REACH;
    if (dx * dx + dy * dy + dz * dz < reach * reach) emit(c, t, row, other);
  }
}
