// The links (springs between two living bodies) and the rows that the solver assigns to them.
import { columns } from '../memory/columns';
import { SpringTable } from '../forces/springs';
import { ConstraintTable, putWord, word } from './table';

// @ts-ignore: decorator
@inline export function linkAt(t: ConstraintTable, link: i32): usize {
  return changetype<SpringTable>(t.springs).links + <usize>link * 12;
}

// @ts-ignore: decorator
@inline export function linkCount(t: ConstraintTable): i32 {
  return changetype<SpringTable>(t.springs).active;
}

// @ts-ignore: decorator
@inline export function hasRow(t: ConstraintTable, link: i32): bool {
  return word(t.assigned, link) != 0;
}

// @ts-ignore: decorator
@inline export function isMovable(body: u32, movable: u32): bool {
  return (word(columns().members, body) & movable) == movable;
}

// Writes link `link` into row `row`.
export function putLink(t: ConstraintTable, row: i32, link: i32): void {
  const p = linkAt(t, link);
  putRow(t, row, load<u32>(p), load<u32>(p, 4), load<u32>(p, 8));
  putWord(t.assigned, link, 1);
}

export function putRow(t: ConstraintTable, row: i32, spring: u32, a: u32, b: u32): void {
  putWord(t.springIds, row, spring);
  putWord(t.a, row, a);
  putWord(t.b, row, b);
  store<real>(t.tension + <usize>row * sizeof<real>(), 0);
}

// Appends `count` padding rows, which belong to no spring.
export function appendPadding(t: ConstraintTable, count: i32): void {
  for (let i = 0; i < count; i++) putRow(t, t.rowCount++, 0, 0, 0);
}
