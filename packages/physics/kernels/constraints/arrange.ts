// Orders the springs for the solver, whenever springs or bodies came or went.
//
// Springs that follow each other along a line, no body joining more than two, are a chain: ropes and pendulums. Chains
// are solved directly, and so are threads (threads.ts). All others are coloured: greedily, in ascending id, each takes the first colour that neither of
// its movable ends has. Bodies that cannot move are never written, so they conflict with nothing.
import { columns } from '../columns';
import { SpringTable } from '../forces/springs';
import { LANES } from '../lanes';
import { kindOf } from './lanes';
import { COLOURS, ConstraintTable, putWord, tableAt, word } from './table';
import { findThreads } from './threads';
import { forgetSum } from './unchanged';

// The state of a spring that has its row already.
export const IN_CHAIN: u32 = 0xffffffff;

// @ts-ignore: decorator
@inline export function linkAt(t: ConstraintTable, link: i32): usize {
  return changetype<SpringTable>(t.springs).links + <usize>link * 12;
}

// @ts-ignore: decorator
@inline export function linkCount(t: ConstraintTable): i32 {
  return changetype<SpringTable>(t.springs).active;
}

// Writes all rows and returns how many are in chains; `movable` are the membership bits of a body that forces can move,
// `lastId` the highest id.
export function arrangeConstraints(table: usize, movable: u32, lastId: i32): i32 {
  const t = tableAt(table);
  forgetSum(t);
  const links = linkCount(t);
  const bodies = <usize>(lastId + 1);
  memory.fill(t.degree, 0, bodies << 2);
  memory.fill(t.masks, 0, bodies << 3);
  memory.fill(t.state, 0, (<usize>links) << 2);
  for (let link = 0; link < links; link++) {
    join(t, load<u32>(linkAt(t, link), 4), link);
    join(t, load<u32>(linkAt(t, link), 8), link);
  }
  t.nodeCount = 0;
  t.looseCount = 0;
  for (let body = 1; body <= lastId; body++) {
    if (word(t.degree, body) > 0) putWord(t.nodes, t.nodeCount++, body);
    else if (isMovable(body, movable)) t.looseCount++;
  }
  t.rowCount = 0;
  findChains(t, links, movable);
  fillUp(t);
  findThreads(t, movable, lastId);
  fillUp(t);
  t.coloursFirst = t.rowCount;
  colourRest(t, links, movable);
  for (let row = t.coloursFirst; row < t.serialFirst; row += LANES) {
    putWord(t.kinds, row / LANES, kindOf(t.a + ((<usize>row) << 2), t.b + ((<usize>row) << 2)));
  }
  return word(t.chains, t.chainCount);
}

// Rows of nothing up to the next multiple of four.
function fillUp(t: ConstraintTable): void {
  while ((t.rowCount & 3) != 0) putRow(t, t.rowCount++, 0, 0, 0);
}

function join(t: ConstraintTable, body: u32, link: i32): void {
  const degree = word(t.degree, body);
  if (degree < 2) putWord(t.joined, body * 2 + degree, link);
  putWord(t.degree, body, degree + 1);
}

// @ts-ignore: decorator
@inline export function isMovable(body: u32, movable: u32): bool {
  return (word(columns().members, body) & movable) == movable;
}

export function putRow(t: ConstraintTable, row: i32, spring: u32, a: u32, b: u32): void {
  putWord(t.source, row, spring);
  putWord(t.a, row, a);
  putWord(t.b, row, b);
  store<real>(t.tension + <usize>row * sizeof<real>(), 0);
}

function findChains(t: ConstraintTable, links: i32, movable: u32): void {
  t.chainCount = 0;
  for (let link = 0; link < links; link++) {
    if (word(t.state, link) != 0) continue;
    const a = load<u32>(linkAt(t, link), 4);
    const b = load<u32>(linkAt(t, link), 8);
    const start = isEnd(t, a, movable) ? a : isEnd(t, b, movable) ? b : 0;
    if (start == 0 || !walk(t, link, start, movable, false)) continue;
    putWord(t.chains, t.chainCount++, t.rowCount);
    walk(t, link, start, movable, true);
  }
  putWord(t.chains, t.chainCount, t.rowCount);
}

function isEnd(t: ConstraintTable, body: u32, movable: u32): bool {
  return !isMovable(body, movable) || word(t.degree, body) == 1;
}

// Follows a line of springs from one end of it; false when it branches. Writes its rows if asked to.
function walk(t: ConstraintTable, link: i32, from: u32, movable: u32, write: bool): bool {
  let node = from;
  let current = link;
  let ended = false;
  while (!ended) {
    const p = linkAt(t, current);
    const a = load<u32>(p, 4);
    const other = a == node ? load<u32>(p, 8) : a;
    if (write) {
      putWord(t.state, current, IN_CHAIN);
      putRow(t, t.rowCount++, load<u32>(p), node, other);
    }
    ended = isEnd(t, other, movable);
    if (!ended && word(t.degree, other) > 2) return false;
    const first = word(t.joined, other * 2);
    current = first == current ? word(t.joined, other * 2 + 1) : first;
    node = other;
  }
  return true;
}

function colourRest(t: ConstraintTable, links: i32, movable: u32): void {
  memory.fill(t.colours, 0, (<usize>(COLOURS + 2)) << 2);
  for (let link = 0; link < links; link++) {
    if (word(t.state, link) == IN_CHAIN) continue;
    const colour = takeColour(t, load<u32>(linkAt(t, link), 4), load<u32>(linkAt(t, link), 8), movable);
    putWord(t.state, link, colour);
    putWord(t.colours, colour, word(t.colours, colour) + 1);
  }
  // Counts become the first row of each colour, and, as rows are placed, its end.
  let next = t.rowCount;
  for (let colour = 0; colour <= COLOURS; colour++) {
    const count = word(t.colours, colour);
    if (colour == COLOURS) t.serialFirst = next;
    putWord(t.colours, colour, next);
    next += (count + 3) & ~3;
  }
  for (let row = t.rowCount; row < next; row++) putRow(t, row, 0, 0, 0);
  t.rowCount = next;
  for (let link = 0; link < links; link++) {
    const colour = word(t.state, link);
    if (colour == IN_CHAIN) continue;
    const p = linkAt(t, link);
    const row = word(t.colours, colour);
    putRow(t, row, load<u32>(p), load<u32>(p, 4), load<u32>(p, 8));
    putWord(t.colours, colour, row + 1);
  }
}

function takeColour(t: ConstraintTable, a: u32, b: u32, movable: u32): u32 {
  const maskA = t.masks + ((<usize>a) << 3);
  const maskB = t.masks + ((<usize>b) << 3);
  const movesA = isMovable(a, movable);
  const movesB = isMovable(b, movable);
  const taken = (movesA ? load<u64>(maskA) : 0) | (movesB ? load<u64>(maskB) : 0);
  const colour = <u32>min<u64>(ctz<u64>(~taken), COLOURS);
  if (colour == COLOURS) return colour;
  const bit = (<u64>1) << colour;
  if (movesA) store<u64>(maskA, load<u64>(maskA) | bit);
  if (movesB) store<u64>(maskB, load<u64>(maskB) | bit);
  return colour;
}
