// The pairs that began in this step, in the order of (a, b), for a function of the user that decides which may collide.
import { word } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { keyOf } from '../../broad-phase/2d/pair-filter';
import { keyAt } from '../../broad-phase/2d/sort-keys';
import { IGNORED, contactAt, contactInOrder } from './rigid-contact';

// The row of one of the shapes of a new pair: that of a for side 0, of b for side 1.
export function newPair(table: usize, i: i32, side: i32): i32 {
  const t = changetype<RigidTable>(table);
  const contact = contactAt(t, word(t.newContacts, i));
  return side == 0 ? contact.a : contact.b;
}

// A new pair does not collide, until its boxes no longer overlap.
export function ignorePair(table: usize, i: i32): void {
  const t = changetype<RigidTable>(table);
  contactAt(t, word(t.newContacts, i)).flags |= IGNORED;
}

// Whether the user's function has refused a pair.
export function isIgnored(t: RigidTable, a: i32, b: i32): bool {
  return (flagsOfPair(t, a, b) & IGNORED) != 0;
}

// The flags of the contact of a pair, 0 if it has none: a binary search.
export function flagsOfPair(t: RigidTable, a: i32, b: i32): u32 {
  const key = keyOf(a, b);
  let low = 0;
  let high = t.contactCount;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (keyAt(t.keys, middle) < key) low = middle + 1;
    else high = middle;
  }
  return low < t.contactCount && keyAt(t.keys, low) == key ? contactInOrder(t, low).flags : 0;
}
