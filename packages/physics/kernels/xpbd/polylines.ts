// Finds polylines: springs made in sequence, each from the body where the previous spring ended, as in cloths and
// ropes. Other springs may be attached to their bodies anywhere. LANES polylines of equal length that share no
// movable body form a batch, which is solved in SIMD lanes: row j of polyline l is first + LANES j + l. Consecutive
// batches that share no movable body form a pass, such as all polylines of a cloth in one direction.
import { LANES } from '../memory/lanes';
import { appendPadding, hasRow, isMovable, linkAt, linkCount, putLink } from './links';
import { ConstraintTable, MAX_PASSES, putWord, word } from './table';

// The minimum number of springs of a polyline: a direct solve of three gains nothing.
const MIN_POLYLINE: i32 = 4;

// Few springs may have up to this many padding rows, so that a single polyline, as of a rope with a branch, is a batch.
const MAX_SMALL_PADDING: i32 = 4096;

// The open batch: its number of polylines, and the springs of each. `t.broken` holds the first link of each polyline.
let polylineCount: i32 = 0;
let springsEach: i32 = 0;
// The padding rows that may still be spent on incomplete batches.
let spare: i32 = 0;

// Assigns all polylines to batches; returns the number of padding rows that may still be spent.
export function findPolylines(t: ConstraintTable, movable: u32, lastId: i32): i32 {
  // `joined` now holds, per body, the last polyline and the last batch that contain it; the chains are done with it.
  memory.fill(t.joined, 0, (<usize>(lastId + 1)) << 3);
  const links = linkCount(t);
  t.batchCount = 0;
  t.longestPolyline = 0;
  t.passCount = 1;
  putWord(t.passes, 0, 0);
  polylineCount = 0;
  spare = max<i32>(links >> 1, min<i32>(3 * links, MAX_SMALL_PADDING));
  let polyline: u32 = 0;
  for (let link = 0; link < links; ) {
    const count = hasRow(t, link) ? 1 : countPolyline(t, link, links, movable, ++polyline);
    if (count >= MIN_POLYLINE) addPolyline(t, link, count, movable);
    link += count;
  }
  closeBatch(t);
  putWord(t.batches, t.batchCount, t.rowCount);
  putWord(t.passes, t.passCount, t.batchCount);
  return spare;
}

// Returns the number of springs from `link` on that form a polyline. It ends before it returns to one of its movable
// bodies.
function countPolyline(t: ConstraintTable, link: i32, links: i32, movable: u32, polyline: u32): i32 {
  let count = 0;
  let end = load<u32>(linkAt(t, link), 4);
  putWord(t.joined, end * 2, polyline);
  while (link + count < links && !hasRow(t, link + count)) {
    const p = linkAt(t, link + count);
    if (load<u32>(p, 4) != end) break;
    end = load<u32>(p, 8);
    if (word(t.joined, end * 2) == polyline && isMovable(end, movable)) break;
    putWord(t.joined, end * 2, polyline);
    count++;
  }
  return max<i32>(1, count);
}

// Adds a polyline to the open batch, or opens a batch for it.
function addPolyline(t: ConstraintTable, link: i32, count: i32, movable: u32): void {
  if (polylineCount == LANES || count != springsEach || conflictsWithBatch(t, link, count, movable)) {
    closeBatch(t);
    openBatch(t, count);
  }
  if (t.passCount < MAX_PASSES && conflictsWithPass(t, link, count, movable)) {
    putWord(t.passes, t.passCount++, t.batchCount - 1);
  }
  const first = <i32>word(t.batches, t.batchCount - 1);
  putWord(t.broken, polylineCount, link);
  for (let j = 0; j < count; j++) {
    const p = linkAt(t, link + j);
    const a = load<u32>(p, 4);
    const b = load<u32>(p, 8);
    putWord(t.joined, a * 2 + 1, t.batchCount);
    putWord(t.joined, b * 2 + 1, t.batchCount);
    putLink(t, first + LANES * j + polylineCount, link + j);
  }
  polylineCount++;
}

function openBatch(t: ConstraintTable, count: i32): void {
  putWord(t.batches, t.batchCount++, t.rowCount);
  springsEach = count;
  appendPadding(t, LANES * count);
}

// Closes the open batch. Unused lanes waste rows; if they exceed `spare`, the springs are left to the groups.
function closeBatch(t: ConstraintTable): void {
  const wasted = (LANES - polylineCount) * springsEach;
  if (polylineCount > 0 && wasted > spare) {
    t.rowCount = word(t.batches, --t.batchCount);
    for (let l = 0; l < polylineCount; l++) {
      for (let j = 0; j < springsEach; j++) putWord(t.assigned, <i32>word(t.broken, l) + j, 0);
    }
  } else if (polylineCount > 0) {
    spare -= wasted;
    t.longestPolyline = max<i32>(t.longestPolyline, springsEach);
  }
  polylineCount = 0;
}

// Tests whether a polyline shares a movable body with the open batch.
function conflictsWithBatch(t: ConstraintTable, link: i32, count: i32, movable: u32): bool {
  return polylineCount == 0 || conflictsWith(t, link, count, movable, t.batchCount, t.batchCount);
}

// Tests whether a polyline shares a movable body with the earlier batches of the open pass.
function conflictsWithPass(t: ConstraintTable, link: i32, count: i32, movable: u32): bool {
  return conflictsWith(t, link, count, movable, <i32>word(t.passes, t.passCount - 1) + 1, t.batchCount - 1);
}

// Tests whether the last batch of any movable body of a polyline is between `first` and `last`, counted from 1.
function conflictsWith(t: ConstraintTable, link: i32, count: i32, movable: u32, first: i32, last: i32): bool {
  for (let j = 0; j < count; j++) {
    const p = linkAt(t, link + j);
    if (j == 0 && isInBatches(t, load<u32>(p, 4), movable, first, last)) return true;
    if (isInBatches(t, load<u32>(p, 8), movable, first, last)) return true;
  }
  return false;
}

function isInBatches(t: ConstraintTable, body: u32, movable: u32, first: i32, last: i32): bool {
  const batch = <i32>word(t.joined, body * 2 + 1);
  return batch >= first && batch <= last && isMovable(body, movable);
}
