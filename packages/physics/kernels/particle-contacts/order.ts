// Puts the pairs into ascending order of (a, b), whatever the grid looked like: the order of the contacts, and so every
// bit of the result, depends on ids alone.
import { put } from '../memory/columns';
import { contactTable, putWord, word } from './table';

// Keeps the contacts of the last step for the new ones to start from, and empties the list.
export function beginContacts(): void {
  const t = contactTable();
  const words = (<usize>t.count) << 2;
  memory.copy(t.previousA, t.a, words);
  memory.copy(t.previousB, t.b, words);
  memory.copy(t.previousHolding, t.holding, <usize>t.count * sizeof<real>());
  t.previousCount = t.count;
  t.count = 0;
  t.lost = 0;
}

// Forgets the contacts with walls of the last step.
export function beginWallContacts(): void {
  const t = contactTable();
  t.wallCount = 0;
  t.wallLost = 0;
}

// Counting sort by a, then insertion by b within the few of each a. `lastId` is the highest id there is.
export function sortContacts(lastId: i32): void {
  const t = contactTable();
  const count = t.count;
  if (count == 0) return;
  const cursor = t.rowWords;
  memory.fill(cursor, 0, (<usize>(lastId + 1)) << 2);
  for (let i = 0; i < count; i++) {
    const a = word(t.slotA, i);
    putWord(cursor, a, word(cursor, a) + 1);
  }
  let sum = 0;
  for (let row = 0; row <= lastId; row++) {
    const size = word(cursor, row);
    putWord(cursor, row, sum);
    sum += size;
  }
  // A place that is still empty must not look like one of this a.
  memory.fill(t.a, 0, (<usize>count) << 2);
  for (let i = 0; i < count; i++) {
    const a = word(t.slotA, i);
    const b = word(t.slotB, i);
    let place = word(cursor, a);
    putWord(cursor, a, place + 1);
    putWord(t.a, place, a);
    while (place > 0 && word(t.a, place - 1) == a && word(t.b, place - 1) > b) {
      putWord(t.b, place, word(t.b, place - 1));
      place--;
    }
    putWord(t.b, place, b);
  }
  memory.fill(t.impulse, 0, <usize>count * sizeof<real>());
  memory.fill(t.holding, 0, <usize>count * sizeof<real>());
}

// The holding impulse of each contact that was there in the last step: both lists ascend, so one pass joins them.
// Impulses grow with the step: `scale` is this dt over the last.
export function joinPrevious(scale: real): void {
  const t = contactTable();
  let p = 0;
  for (let i = 0; i < t.count && p < t.previousCount; i++) {
    const a = word(t.a, i);
    const b = word(t.b, i);
    while (p < t.previousCount) {
      const pa = word(t.previousA, p);
      if (pa > a || (pa == a && word(t.previousB, p) >= b)) break;
      p++;
    }
    if (p < t.previousCount && word(t.previousA, p) == a && word(t.previousB, p) == b) {
      put(t.holding, i, load<real>(t.previousHolding + <usize>p * sizeof<real>()) * scale);
    }
  }
}
