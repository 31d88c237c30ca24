// Colors the touching contacts, so that contacts of one color have no moving body in common and LANES of them can be solved
// at once.
//
// Each contact takes the first color that neither of its bodies has, in the order of (a, b): the result depends on nothing
// but the contacts. Contacts with a body that does not move have separate colors, which are solved last, because
// such a contact must not yield. Contacts that find no color are solved one at a time, before all others.
// Source: constraint_graph.c of Box2D 3, which keeps its colors from step to step.
import { LANES } from '../../memory/lanes';
import { COVERED, TOUCHING, contactAt } from '../../collision/narrow-phase/2d/rigid-contact';
import { flagsOf, isPushed, putWord, word } from './body';
import { COLORS, RigidTable } from './rigid-table';

// Bits of colors: 0 to 19 for two bodies that move, 20 to 30 for one. The last is for contacts without a color.
const PAIR_COLORS: u32 = 0x000fffff;
const SINGLE_COLORS: u32 = 0x7ff00000;
const UNCOLORED: i32 = COLORS - 1;

// Lists what the solver has to do, and lays out blocks of LANES: t.colors holds the first lane of each color.
export function colorContacts(table: usize): void {
  const t = changetype<RigidTable>(table);
  for (let i = 0; i < t.awakeCount; i++) putWord(t.usedColors, word(t.awake, i), 0);
  memory.fill(t.colorCounts, 0, (<usize>COLORS) << 2);
  let count = 0;
  let blocks = 0;
  for (let i = 0; i < t.currentCount; i++) {
    const slot = word(t.current, i);
    const contact = contactAt(t, slot);
    if ((contact.flags & (TOUCHING | COVERED)) != TOUCHING) continue;
    const movesA = isPushed(flagsOf(t, contact.bodyA));
    const movesB = isPushed(flagsOf(t, contact.bodyB));
    if (!movesA && !movesB) continue;
    const color = chooseColor(t, contact.bodyA, contact.bodyB, movesA, movesB);
    const size = word(t.colorCounts, color);
    if (color == UNCOLORED || (size & (LANES - 1)) == 0) {
      if (blocks == t.blockCapacity) {
        t.droppedCount++;
        continue;
      }
      blocks++;
    }
    putWord(t.colorCounts, color, size + 1);
    putWord(t.touching, 2 * count, slot);
    putWord(t.touching, 2 * count++ + 1, color);
  }
  t.touchingCount = count;
  layOutBlocks(t);
}

// @ts-ignore: decorator
@inline function chooseColor(t: RigidTable, a: i32, b: i32, movesA: bool, movesB: bool): i32 {
  const usedA: u32 = movesA ? <u32>word(t.usedColors, a) : 0;
  const usedB: u32 = movesB ? <u32>word(t.usedColors, b) : 0;
  const open = (movesA && movesB ? PAIR_COLORS : SINGLE_COLORS) & ~(usedA | usedB);
  if (open == 0) return UNCOLORED;
  const bit = open & (0 - open);
  if (movesA) putWord(t.usedColors, a, usedA | bit);
  if (movesB) putWord(t.usedColors, b, usedB | bit);
  return ctz<u32>(bit);
}

// Contacts without a color come first, one per block. Contacts that take their lanes in the same order get the same again.
export function layOutBlocks(t: RigidTable): void {
  let lane = word(t.colorCounts, UNCOLORED) * LANES;
  putWord(t.colors, UNCOLORED, 0);
  for (let color = 0; color < UNCOLORED; color++) {
    putWord(t.colors, color, lane);
    lane += (word(t.colorCounts, color) + LANES - 1) & -LANES;
  }
  t.blockCount = lane / LANES;
}

// The lane of the next contact of a color.
// @ts-ignore: decorator
@inline export function takeLane(t: RigidTable, color: i32): i32 {
  const lane = word(t.colors, color);
  putWord(t.colors, color, lane + (color == UNCOLORED ? LANES : 1));
  return lane;
}
