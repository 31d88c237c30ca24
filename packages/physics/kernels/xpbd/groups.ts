// Springs of no chain and no thread: groups of four that share no movable body, so that LANES of them are solved at once
// with the same result as one after the other. Bodies that cannot move are never written: they conflict with nothing.
import { hasRow, isMovable, linkAt, linkCount, putLink, putNothing } from './links';
import { ConstraintTable, OPEN_GROUPS, putWord, word } from './table';

// Springs of a group: the lanes of f32, so that both precisions solve them in one order.
const GROUP: i32 = 4;

// Each spring, in ascending id, goes into the first open group that has neither of its ends: springs made one after the
// other are solved so, while their bodies are in the cache. `spare` rows may stay empty; where that is not enough, as
// at a body with hundreds of springs, the others are solved one by one.
export function groupLinks(t: ConstraintTable, movable: u32, spare: i32): void {
  const links = linkCount(t);
  let rest = 0;
  for (let link = 0; link < links; link++) if (!hasRow(t, link)) rest++;
  const room = t.rowCount + rest + spare;
  t.groupsFirst = t.rowCount;
  // A bit for each group that is open, and per body for each that it is in.
  let open: u64 = 0;
  let opened = 0;
  for (let link = 0; link < links; link++) {
    if (hasRow(t, link)) continue;
    const p = linkAt(t, link);
    const a = isMovable(load<u32>(p, 4), movable) ? maskAt(t, load<u32>(p, 4)) : 0;
    const b = isMovable(load<u32>(p, 8), movable) ? maskAt(t, load<u32>(p, 8)) : 0;
    const free = open & ~((a != 0 ? load<u64>(a) : 0) | (b != 0 ? load<u64>(b) : 0));
    let group = <i32>ctz<u64>(free);
    if (free == 0) {
      if (t.rowCount + GROUP + rest > room) continue;
      group = opened++ % OPEN_GROUPS;
      if (((open >> group) & 1) != 0) close(t, group);
      putWord(t.open, group, t.rowCount);
      putNothing(t, GROUP);
    }
    const bit = (<u64>1) << group;
    const row = <i32>word(t.open, group);
    putLink(t, row, link);
    putWord(t.open, group, row + 1);
    rest--;
    open |= bit;
    if (a != 0) store<u64>(a, load<u64>(a) | bit);
    if (b != 0) store<u64>(b, load<u64>(b) | bit);
    if (row % GROUP < GROUP - 1) continue;
    close(t, group);
    open &= ~bit;
  }
  t.serialFirst = t.rowCount;
  for (let link = 0; link < links; link++) if (!hasRow(t, link)) putLink(t, t.rowCount++, link);
}

// @ts-ignore: decorator
@inline function maskAt(t: ConstraintTable, body: u32): usize {
  return t.masks + ((<usize>body) << 3);
}

// Takes a group from the bodies that are in it.
function close(t: ConstraintTable, group: i32): void {
  const others = ~((<u64>1) << group);
  const first = (<i32>word(t.open, group) - 1) & -GROUP;
  for (let row = first; row < first + GROUP; row++) {
    const a = maskAt(t, word(t.a, row));
    const b = maskAt(t, word(t.b, row));
    store<u64>(a, load<u64>(a) & others);
    store<u64>(b, load<u64>(b) & others);
  }
}
