// Sorts the pairs by (a, b), so that the order of the contacts, and with it every bit of the result, depends on the ids
// alone and not on the grid.
import { put } from '../memory/columns';
import { contactTable, putWord, word } from './table';

// Saves the contacts of the last step for warm starting, and clears the list.
export function beginContacts(): void {
  const t = contactTable();
  const words = (<usize>t.count) << 2;
  memory.copy(t.previousA, t.a, words);
  memory.copy(t.previousB, t.b, words);
  memory.copy(t.previousAccumulatedImpulse, t.accumulatedImpulse, <usize>t.count * sizeof<real>());
  t.previousCount = t.count;
  t.count = 0;
  t.droppedCount = 0;
}

// Clears the wall contacts of the last step.
export function beginWallContacts(): void {
  const t = contactTable();
  t.wallCount = 0;
  t.wallDroppedCount = 0;
}

// Sorts by a with a counting sort, then by b with insertion within each a. `lastId` is the highest entity id.
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
  // Unwritten entries must not compare equal to any a.
  memory.fill(t.a, 0, (<usize>count) << 2);
  for (let i = 0; i < count; i++) {
    const a = word(t.slotA, i);
    const b = word(t.slotB, i);
    let position = word(cursor, a);
    putWord(cursor, a, position + 1);
    putWord(t.a, position, a);
    while (position > 0 && word(t.a, position - 1) == a && word(t.b, position - 1) > b) {
      putWord(t.b, position, word(t.b, position - 1));
      position--;
    }
    putWord(t.b, position, b);
  }
  memory.fill(t.impulse, 0, <usize>count * sizeof<real>());
  memory.fill(t.accumulatedImpulse, 0, <usize>count * sizeof<real>());
}

// Copies the resting impulse of each contact that persists from the last step. Both lists are sorted, so one pass
// merges them. Impulses are proportional to the step: `scale` is the ratio of this dt to the last.
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
      put(t.accumulatedImpulse, i, load<real>(t.previousAccumulatedImpulse + <usize>p * sizeof<real>()) * scale);
    }
  }
}
