// What the contacts of a world are kept in: a table of counters and addresses in the world's memory.
// src/particle-contacts/contact-table.ts makes it.
import { columns } from '../memory/columns';

@unmanaged
export class ContactTable {
  // Length of the last step, s.
  previousDt: f64;
  // Contacts between bodies: ids a < b, unit normal from a to b, impulse of this step along it (N s), the part of the
  // impulse that holds a resting contact, from which the next step starts, and what friction has done (RUBBING_SIZE).
  capacity: i32;
  count: i32;
  // Candidates this step had no room or no time for.
  lost: u32;
  a: usize;
  b: usize;
  nx: usize;
  ny: usize;
  nz: usize;
  impulse: usize;
  holding: usize;
  rubbing: usize;
  // Where the two bodies of a contact are in `bodies`; before that, the pairs as the grid finds them.
  slotA: usize;
  slotB: usize;
  // The contacts of the last step; then an order of this step's, their flags, then levels, and their gaps; then points
  // of contact.
  previousCount: i32;
  previousA: usize;
  previousB: usize;
  previousHolding: usize;
  order: usize;
  flags: usize;
  gap: usize;
  x: usize;
  y: usize;
  z: usize;
  // Contacts with walls: body, wall (0 for a box), normal out of the wall, impulse, part that holds a resting body, and
  // the gap to a wall that is near but was not touched; then the speed at which the body may come to it.
  wallCapacity: i32;
  wallCount: i32;
  wallLost: u32;
  wallBody: usize;
  wallId: usize;
  wallNx: usize;
  wallNy: usize;
  wallNz: usize;
  wallImpulse: usize;
  wallHolding: usize;
  wallGap: usize;
  // Its coefficient of friction, the impulse that friction was reckoned with already, the friction since (three f32), and
  // where its body is in `bodies`.
  wallFriction: usize;
  wallRubbed: usize;
  wallRubbing: usize;
  wallSlot: usize;
  // Resting contacts packed by levels (abreast.ts), LANES a block, and the most keys there is room to count in `levels`.
  blocks: usize;
  levels: usize;
  mostLevels: i32;
  // Bodies with contacts, gathered, and their rows.
  bodies: usize;
  bodyRows: usize;
  bodyCount: i32;
  // Grid: one word a row, first body of each bucket, bodies in the order of their buckets. The last two lie where
  // `bodies` come later.
  rowWords: usize;
  starts: usize;
  // The same bodies as columns. They lie where the blocks come later.
  sortedX: usize;
  sortedY: usize;
  sortedZ: usize;
  sortedRadius: usize;
  sortedBucket: usize;
  sortedRow: usize;
  maxBuckets: i32;
  // Chosen each step: buckets (a power of two), distance in buckets between neighbours in y and z, bodies in the grid,
  // bodies too large for it.
  buckets: i32;
  stride: i32;
  layer: i32;
  gridCount: i32;
  largeCount: i32;
  histogram: usize;
  // Columns of the scratch: velocity at the start of the step, position before contacts.
  startX: usize;
  startY: usize;
  startZ: usize;
  fromX: usize;
  fromY: usize;
}

// Friction of a contact between bodies: the tangential impulse so far as three f32, and the coefficient.
export const RUBBING_SIZE: usize = 16;

// @ts-ignore: decorator
@inline export function rubbing(t: ContactTable, i: i32): usize {
  return t.rubbing + <usize>i * RUBBING_SIZE;
}

// @ts-ignore: decorator
@inline export function contactTable(): ContactTable {
  return changetype<ContactTable>(columns().contacts);
}

// @ts-ignore: decorator
@inline export function word(column: usize, i: i32): i32 {
  return load<i32>(column + ((<usize>i) << 2));
}

// @ts-ignore: decorator
@inline export function putWord(column: usize, i: i32, value: i32): void {
  store<i32>(column + ((<usize>i) << 2), value);
}

// Larger than any sound result and smaller than what overflows when it is used once more.
export const FINITE: real = sizeof<real>() == 4 ? <real>1e37 : <real>1e300;

// Contacts are looked for out to this multiple of the radius, or of the sum of the radii: bodies that lie on each other
// keep their contact, and the impulse that holds them, while they come apart by less than this.
export const REACH: real = 1.01;

// Walls are noted out to this multiple of the radius: what lies on a body may press it there within the step.
export const WALL_REACH: real = 1.1;
