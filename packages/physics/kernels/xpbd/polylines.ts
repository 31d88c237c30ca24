// Finds threads: springs made one after the other, each from the body where the last one ended, as cloths and ropes are
// woven. Other springs may hold on to their bodies anywhere. LANES threads of one length that share no movable body are
// a strand: they are solved side by side, row j of thread l standing at first + LANES j + l. Strands that follow each
// other and share no movable body are a layer, such as all threads of a cloth in one direction.
import { LANES } from '../memory/lanes';
import { hasRow, isMovable, linkAt, linkCount, putLink, putNothing } from './links';
import { ConstraintTable, LAYERS, putWord, word } from './table';

// Springs of the shortest thread: solving three directly gains nothing.
const SHORTEST: i32 = 4;

// The first springs of the threads in the strand that is being filled, their number, and the springs of each.
let filled: i32 = 0;
let length: i32 = 0;
// Rows of nothing that may still be spent on strands of fewer threads.
let spare: i32 = 0;

// Returns how many rows of nothing may still be spent.
export function findThreads(t: ConstraintTable, movable: u32, lastId: i32): i32 {
  // Per body the last thread and the last strand it was in; chains need this no more.
  memory.fill(t.joined, 0, (<usize>(lastId + 1)) << 3);
  const links = linkCount(t);
  t.strandCount = 0;
  t.longest = 0;
  t.layerCount = 1;
  putWord(t.layers, 0, 0);
  filled = 0;
  spare = links >> 1;
  let thread: u32 = 0;
  for (let link = 0; link < links; ) {
    const count = hasRow(t, link) ? 1 : follow(t, link, links, movable, ++thread);
    if (count >= SHORTEST) join(t, link, count, movable);
    link += count;
  }
  closeStrand(t);
  putWord(t.strands, t.strandCount, t.rowCount);
  putWord(t.layers, t.layerCount, t.strandCount);
  return spare;
}

// The number of springs from `link` on that make a thread. One that comes back to a movable body ends before.
function follow(t: ConstraintTable, link: i32, links: i32, movable: u32, thread: u32): i32 {
  let count = 0;
  let end = load<u32>(linkAt(t, link), 4);
  putWord(t.joined, end * 2, thread);
  while (link + count < links && !hasRow(t, link + count)) {
    const p = linkAt(t, link + count);
    if (load<u32>(p, 4) != end) break;
    end = load<u32>(p, 8);
    if (word(t.joined, end * 2) == thread && isMovable(end, movable)) break;
    putWord(t.joined, end * 2, thread);
    count++;
  }
  return max<i32>(1, count);
}

// Puts a thread into the open strand, or opens one for it.
function join(t: ConstraintTable, link: i32, count: i32, movable: u32): void {
  if (filled == LANES || count != length || meets(t, link, count, movable)) {
    closeStrand(t);
    openStrand(t, count);
  }
  if (t.layerCount < LAYERS && crosses(t, link, count, movable)) putWord(t.layers, t.layerCount++, t.strandCount - 1);
  const first = <i32>word(t.strands, t.strandCount - 1);
  putWord(t.broken, filled, link);
  for (let j = 0; j < count; j++) {
    const p = linkAt(t, link + j);
    const a = load<u32>(p, 4);
    const b = load<u32>(p, 8);
    putWord(t.joined, a * 2 + 1, t.strandCount);
    putWord(t.joined, b * 2 + 1, t.strandCount);
    putLink(t, first + LANES * j + filled, link + j);
  }
  filled++;
}

function openStrand(t: ConstraintTable, count: i32): void {
  putWord(t.strands, t.strandCount++, t.rowCount);
  length = count;
  putNothing(t, LANES * count);
}

// A strand with fewer threads than lanes wastes rows: where that is too many, its springs are left to the groups.
function closeStrand(t: ConstraintTable): void {
  const waste = (LANES - filled) * length;
  if (filled > 0 && waste > spare) {
    t.rowCount = word(t.strands, --t.strandCount);
    for (let l = 0; l < filled; l++) {
      for (let j = 0; j < length; j++) putWord(t.state, <i32>word(t.broken, l) + j, 0);
    }
  } else if (filled > 0) {
    spare -= waste;
    t.longest = max<i32>(t.longest, length);
  }
  filled = 0;
}

// Whether a thread shares a movable body with one of the open strand.
function meets(t: ConstraintTable, link: i32, count: i32, movable: u32): bool {
  return filled == 0 || isTaken(t, link, count, movable, t.strandCount, t.strandCount);
}

// The same with one of the strands of the open layer before.
function crosses(t: ConstraintTable, link: i32, count: i32, movable: u32): bool {
  return isTaken(t, link, count, movable, <i32>word(t.layers, t.layerCount - 1) + 1, t.strandCount - 1);
}

// Whether the last strand of one of a thread's movable bodies is among those from `first` to `last`, counted from 1.
function isTaken(t: ConstraintTable, link: i32, count: i32, movable: u32, first: i32, last: i32): bool {
  for (let j = 0; j < count; j++) {
    const p = linkAt(t, link + j);
    if (j == 0 && isIn(t, load<u32>(p, 4), movable, first, last)) return true;
    if (isIn(t, load<u32>(p, 8), movable, first, last)) return true;
  }
  return false;
}

function isIn(t: ConstraintTable, body: u32, movable: u32, first: i32, last: i32): bool {
  const strand = <i32>word(t.joined, body * 2 + 1);
  return strand >= first && strand <= last && isMovable(body, movable);
}
