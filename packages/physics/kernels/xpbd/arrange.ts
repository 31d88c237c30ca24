// Assigns springs to rows of the solver, whenever springs or bodies were added or removed.
//
// Springs along a line, with no body joining more than two, are a chain: ropes and pendulums. Chains are solved
// directly, and so are polylines (polylines.ts); all other springs form groups (groups.ts).
import { groupLinks } from './groups';
import { appendPadding, hasRow, isMovable, linkAt, linkCount, putRow } from './links';
import { ConstraintTable, putWord, tableAt, word } from './table';
import { findPolylines } from './polylines';
import { invalidateChecksum } from './checksum';

// Writes all rows and returns how many are in chains. `movable` are the membership bits of a body that forces can
// move, `lastId` is the highest id.
export function arrangeConstraints(table: usize, movable: u32, lastId: i32): i32 {
  const t = tableAt(table);
  invalidateChecksum(t);
  const links = linkCount(t);
  const bodies = <usize>(lastId + 1);
  memory.fill(t.degree, 0, bodies << 2);
  memory.fill(t.groupMasks, 0, bodies << 3);
  memory.fill(t.assigned, 0, (<usize>links) << 2);
  for (let link = 0; link < links; link++) {
    countSpring(t, load<u32>(linkAt(t, link), 4), link);
    countSpring(t, load<u32>(linkAt(t, link), 8), link);
  }
  t.nodeCount = 0;
  t.freeBodyCount = 0;
  for (let body = 1; body <= lastId; body++) {
    if (word(t.degree, body) > 0) putWord(t.nodes, t.nodeCount++, body);
    else if (isMovable(body, movable)) t.freeBodyCount++;
  }
  t.rowCount = 0;
  findChains(t, links, movable);
  padRows(t);
  const spare = findPolylines(t, movable, lastId);
  padRows(t);
  groupLinks(t, movable, spare);
  return word(t.chains, t.chainCount);
}

// Pads the rows to a multiple of four.
function padRows(t: ConstraintTable): void {
  appendPadding(t, -t.rowCount & 3);
}

function countSpring(t: ConstraintTable, body: u32, link: i32): void {
  const degree = word(t.degree, body);
  if (degree < 2) putWord(t.joined, body * 2 + degree, link);
  putWord(t.degree, body, degree + 1);
}

function findChains(t: ConstraintTable, links: i32, movable: u32): void {
  t.chainCount = 0;
  for (let link = 0; link < links; link++) {
    if (hasRow(t, link)) continue;
    const a = load<u32>(linkAt(t, link), 4);
    const b = load<u32>(linkAt(t, link), 8);
    const start = isChainEnd(t, a, movable) ? a : isChainEnd(t, b, movable) ? b : 0;
    if (start == 0 || !followChain(t, link, start, movable, false)) continue;
    putWord(t.chains, t.chainCount++, t.rowCount);
    followChain(t, link, start, movable, true);
  }
  putWord(t.chains, t.chainCount, t.rowCount);
}

function isChainEnd(t: ConstraintTable, body: u32, movable: u32): bool {
  return !isMovable(body, movable) || word(t.degree, body) == 1;
}

// Follows a chain from one of its ends; returns false if it branches. Writes its rows if `write` is set.
function followChain(t: ConstraintTable, link: i32, from: u32, movable: u32, write: bool): bool {
  let node = from;
  let current = link;
  let ended = false;
  while (!ended) {
    const p = linkAt(t, current);
    const a = load<u32>(p, 4);
    const other = a == node ? load<u32>(p, 8) : a;
    if (write) {
      putWord(t.assigned, current, 1);
      putRow(t, t.rowCount++, load<u32>(p), node, other);
    }
    ended = isChainEnd(t, other, movable);
    if (!ended && word(t.degree, other) > 2) return false;
    const first = word(t.joined, other * 2);
    current = first == current ? word(t.joined, other * 2 + 1) : first;
    node = other;
  }
  return true;
}
