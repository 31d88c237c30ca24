// Springs that belong to no chain and no polyline: groups of four that share no movable body. LANES springs of a
// group are solved at once, with the same result as in sequence. An immovable body is never written, so it causes no
// conflict.
import { appendPadding, hasRow, isMovable, linkAt, linkCount, putLink } from './links';
import { ConstraintTable, OPEN_GROUPS, putWord, word } from './table';

// The number of springs in a group: the lanes of f32, so that both precisions solve them in the same order.
const GROUP_SIZE: i32 = 4;

// Puts each spring, in ascending id, into the first open group that contains neither of its ends. Springs that were
// made in sequence are then solved in sequence, while their bodies are in the cache. At most `spare` rows may become
// padding; if that is too few, as at a body with hundreds of springs, the remaining springs are solved one by one.
export function groupLinks(t: ConstraintTable, movable: u32, spare: i32): void {
  const links = linkCount(t);
  let remaining = 0;
  for (let link = 0; link < links; link++) if (!hasRow(t, link)) remaining++;
  const maxRows = t.rowCount + remaining + spare;
  t.groupsFirst = t.rowCount;
  // The bitmask of the open groups; `t.groupMasks` holds the same bits for the groups that a body is in.
  let open: u64 = 0;
  let openedCount = 0;
  for (let link = 0; link < links; link++) {
    if (hasRow(t, link)) continue;
    const p = linkAt(t, link);
    const a = isMovable(load<u32>(p, 4), movable) ? maskAddress(t, load<u32>(p, 4)) : 0;
    const b = isMovable(load<u32>(p, 8), movable) ? maskAddress(t, load<u32>(p, 8)) : 0;
    const free = open & ~((a != 0 ? load<u64>(a) : 0) | (b != 0 ? load<u64>(b) : 0));
    let group = <i32>ctz<u64>(free);
    if (free == 0) {
      if (t.rowCount + GROUP_SIZE + remaining > maxRows) continue;
      group = openedCount++ % OPEN_GROUPS;
      if (((open >> group) & 1) != 0) closeGroup(t, group);
      putWord(t.openGroups, group, t.rowCount);
      appendPadding(t, GROUP_SIZE);
    }
    const bit = (<u64>1) << group;
    const row = <i32>word(t.openGroups, group);
    putLink(t, row, link);
    putWord(t.openGroups, group, row + 1);
    remaining--;
    open |= bit;
    if (a != 0) store<u64>(a, load<u64>(a) | bit);
    if (b != 0) store<u64>(b, load<u64>(b) | bit);
    if (row % GROUP_SIZE < GROUP_SIZE - 1) continue;
    closeGroup(t, group);
    open &= ~bit;
  }
  t.serialFirst = t.rowCount;
  for (let link = 0; link < links; link++) if (!hasRow(t, link)) putLink(t, t.rowCount++, link);
}

// @ts-ignore: decorator
@inline function maskAddress(t: ConstraintTable, body: u32): usize {
  return t.groupMasks + ((<usize>body) << 3);
}

// Closes a group: clears its bit in the masks of its bodies.
function closeGroup(t: ConstraintTable, group: i32): void {
  const keepMask = ~((<u64>1) << group);
  const first = (<i32>word(t.openGroups, group) - 1) & -GROUP_SIZE;
  for (let row = first; row < first + GROUP_SIZE; row++) {
    const a = maskAddress(t, word(t.a, row));
    const b = maskAddress(t, word(t.b, row));
    store<u64>(a, load<u64>(a) & keepMask);
    store<u64>(b, load<u64>(b) & keepMask);
  }
}
