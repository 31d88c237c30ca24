// Where the broad phase puts the pairs it finds, and how much it may do: a heap of bodies in one place has a number of
// pairs that grows with its square. What is left out is counted in `lost`, never silent.
import { Columns, get } from '../columns';
import { ContactTable, putWord } from './table';

// Candidates looked at for one body, and contacts kept for it as the one that found them.
export const MOST_TESTS: i32 = 4096;
export const MOST_CONTACTS: i32 = 128;

// Adds the pair of rows p and q, smaller first, unless neither can move. Returns 1 when it was added.
// @ts-ignore: decorator
@inline export function emit(c: Columns, t: ContactTable, p: i32, q: i32): i32 {
  if (!(get(c.mass, p) > 0 || get(c.mass, q) > 0)) return 0;
  const i = t.count;
  if (i >= t.capacity) {
    t.lost++;
    return 0;
  }
  t.count = i + 1;
  putWord(t.slotA, i, min<i32>(p, q));
  putWord(t.slotB, i, max<i32>(p, q));
  return 1;
}
