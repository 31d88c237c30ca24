// Leaves out the contacts between the ends of a spring that is shorter than the sum of their radii: it holds them in each
// other, and a contact would only push against it.
import { columns, get } from '../memory/columns';
import { SpringTable } from '../forces/springs';
import { ContactTable, contactTable, putWord, word } from './table';

// Must follow the sort, which leaves in `rowWords` where the contacts of each body end. No contact has the id 0.
export function omitLinked(springs: usize): void {
  const t = contactTable();
  const s = changetype<SpringTable>(springs);
  if (t.count == 0) return;
  const c = columns();
  let omitted = 0;
  for (let i = 0; i < s.active; i++) {
    const link = s.links + <usize>i * 12;
    const a = load<i32>(link, 4);
    const b = load<i32>(link, 8);
    if (get(s.length, load<i32>(link)) >= get(c.radius, a) + get(c.radius, b)) continue;
    omitted += omit(t, min<i32>(a, b), max<i32>(a, b));
  }
  if (omitted > 0) compactContacts(t);
}

function omit(t: ContactTable, a: i32, b: i32): i32 {
  for (let i = min<i32>(word(t.rowWords, a), t.count) - 1; i >= 0 && word(t.a, i) == a; i--) {
    if (word(t.b, i) != b) continue;
    putWord(t.b, i, 0);
    return 1;
  }
  return 0;
}

function compactContacts(t: ContactTable): void {
  let kept = 0;
  for (let i = 0; i < t.count; i++) {
    if (word(t.b, i) == 0) continue;
    putWord(t.a, kept, word(t.a, i));
    putWord(t.b, kept++, word(t.b, i));
  }
  t.count = kept;
}
