// Broad phase for discs: the pairs of bodies closer than REACH times the sum of their radii.
import { Columns, columns, get } from '../../columns';
import { emit, MOST_CONTACTS, MOST_TESTS } from '../emit';
import { cellOf, chooseGrid, gridRadius, isRound, sumStarts } from '../grid';
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

// Finds the pairs among the bodies `ids`, ascending, into the raw list.
export function findPairs2d(ids: usize, count: i32): void {
  const c = columns();
  const t = contactTable();
  chooseGrid(c, t, ids, count, 2);
  fill(c, t, ids, count);
  const starts = t.starts;
  const stride = t.stride;
  const mask = t.buckets - 1;
  for (let bucket = 0; bucket <= mask; bucket++) {
    const first = word(starts, bucket);
    const last = word(starts, bucket + 1);
    if (first == last) continue;
    const above = (bucket + stride - 1) & mask;
    if (bucket + 2 > mask || above + 2 > mask) {
      for (let i = first; i < last; i++) scanWrapped(c, t, i, last, bucket);
      continue;
    }
    const end = word(starts, bucket + 2);
    const aboveFirst = word(starts, above);
    const aboveLast = word(starts, above + 3);
    for (let i = first; i < last; i++) {
      const found = t.count;
      const left = scan(c, t, i, i + 1, end, MOST_TESTS, found);
      scan(c, t, i, aboveFirst, aboveLast, left, found);
    }
  }
  for (let l = 0; l < t.largeCount; l++) scanLarge(c, t, l);
}

// Sorts the bodies into buckets: count, sum, place. Ids ascend within a bucket because they are placed in order.
function fill(c: Columns, t: ContactTable, ids: usize, count: i32): void {
  const mask = t.buckets - 1;
  const stride = t.stride;
  memory.fill(t.starts, 0, (<usize>(mask + 2)) << 2);
  t.largeCount = 0;
  for (let i = 0; i < count; i++) {
    const row = word(ids, i);
    const radius = get(c.radius, row);
    if (!isRound(radius)) continue;
    if (radius > gridRadius) {
      putWord(t.large, t.largeCount++, row);
      continue;
    }
    const bucket = (cellOf(get(c.positionX, row)) + stride * cellOf(get(c.positionY, row))) & mask;
    putWord(t.rowWords, row, bucket);
    putWord(t.starts, bucket + 1, word(t.starts, bucket + 1) + 1);
  }
  sumStarts(t);
  for (let i = 0; i < count; i++) {
    const row = word(ids, i);
    const radius = get(c.radius, row);
    if (!isRound(radius) || radius > gridRadius) continue;
    const cursor = t.starts + ((<usize>word(t.rowWords, row)) << 2) + 4;
    const place = load<i32>(cursor);
    store<i32>(cursor, place + 1);
    const to = disc(t, place);
    to.x = get(c.positionX, row);
    to.y = get(c.positionY, row);
    to.radius = radius;
    to.row = row;
  }
}

// Tests disc i against the discs [first, last) and returns how many tests are left of `tests`. `found` is the number of
// contacts before this body's first.
// @ts-ignore: decorator
@inline function scan(c: Columns, t: ContactTable, i: i32, first: i32, last: i32, tests: i32, found: i32): i32 {
  const body = disc(t, i);
  const x = body.x;
  const y = body.y;
  const radius = body.radius;
  const end = first + (t.count < t.capacity ? min<i32>(last - first, tests) : 0);
  t.lost += last - end;
  for (let j = first; j < end; j++) {
    const other = disc(t, j);
    const dx = other.x - x;
    const dy = other.y - y;
    const reach = (other.radius + radius) * REACH;
    if (dx * dx + dy * dy < reach * reach) {
      emit(c, t, body.row, other.row);
      if (t.count - found >= MOST_CONTACTS) {
        t.lost += end - j - 1;
        break;
      }
    }
  }
  return tests - (end - first);
}

// The same where the table of buckets ends among the neighbours.
function scanWrapped(c: Columns, t: ContactTable, i: i32, last: i32, bucket: i32): void {
  const mask = t.buckets - 1;
  const found = t.count;
  let tests = scan(c, t, i, i + 1, last, MOST_TESTS, found);
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
