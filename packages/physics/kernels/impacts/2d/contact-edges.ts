// The contact graph: each contact has two edges, one at a and one at b, and a body the list of those of all contacts that push it.
import { get } from '../../memory/columns';
import { LANES } from '../../memory/lanes';
import { flagsOf, isPushed, putWord, word } from '../../solver/2d/body';
import * as block from '../../solver/2d/contact-block';
import { blockAt, contactOf, laneAt } from '../../solver/2d/contact-place';
import { RigidTable } from '../../solver/2d/rigid-table';

// Makes the lists of all bodies, and forgets the impacts of the last time.
export function linkContacts(t: RigidTable): void {
  for (let i = 0; i < t.awakeCount; i++) {
    putWord(t.firstEdges, word(t.awake, i), 0);
    putWord(t.visits, word(t.awake, i), 0);
    putWord(t.pushes, word(t.awake, i), 0);
  }
  for (let place = t.blockCount * LANES - 1; place >= 0; place--) {
    putWord(t.impactOf, place, 0);
    if (get(blockAt(t, place) + block.POINTS + block.NORMAL_MASS, laneAt(place)) == 0) continue;
    const contact = contactOf(t, place);
    linkEdge(t, contact.bodyA, 2 * place);
    linkEdge(t, contact.bodyB, 2 * place + 1);
  }
}

// @ts-ignore: decorator
@inline function linkEdge(t: RigidTable, row: i32, edge: i32): void {
  if (!isPushed(flagsOf(t, row))) return;
  putWord(t.nextEdges, edge, word(t.firstEdges, row));
  putWord(t.firstEdges, row, edge + 1);
}

// The first and the next edge of a body, or -1.
// @ts-ignore: decorator
@inline export function firstEdge(t: RigidTable, row: i32): i32 {
  return word(t.firstEdges, row) - 1;
}

// @ts-ignore: decorator
@inline export function nextEdge(t: RigidTable, edge: i32): i32 {
  return word(t.nextEdges, edge) - 1;
}

// Whether a search comes to a body that contacts push for the first time.
export function visit(t: RigidTable, row: i32, search: i32): bool {
  if (row == 0 || word(t.visits, row) == search) return false;
  putWord(t.visits, row, search);
  return true;
}
