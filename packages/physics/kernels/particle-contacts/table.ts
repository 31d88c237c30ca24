// The contact table of a world: counters and addresses of columns in the world's memory.
// src/particle-contacts/contact-table.ts creates it.
import { columns } from '../memory/columns';

@unmanaged
export class ContactTable {
  // Length of the last step, s.
  previousDt: f64;
  // Contacts between bodies: ids a < b, unit normal from a to b, speed of approach along it (m/s), normal impulse of this
  // step (N s), the part of it from resting contact, which warm starts the next step, and the friction state
  // (FRICTION_STATE_SIZE bytes).
  capacity: i32;
  count: i32;
  // Count of candidates dropped because a limit was reached.
  droppedCount: u32;
  a: usize;
  b: usize;
  nx: usize;
  ny: usize;
  nz: usize;
  speed: usize;
  impulse: usize;
  accumulatedImpulse: usize;
  frictionState: usize;
  // Slots of the two bodies in `bodies`; earlier in the step, the unsorted pairs from the grid.
  slotA: usize;
  slotB: usize;
  // Contacts of the last step; then the solving order, flags (later batches) and gaps of this step's contacts; then the
  // contact points.
  previousCount: i32;
  previousA: usize;
  previousB: usize;
  previousAccumulatedImpulse: usize;
  order: usize;
  flags: usize;
  gap: usize;
  x: usize;
  y: usize;
  z: usize;
  // Wall contacts: body, wall (0 for a box), normal out of the wall, speed of approach along it, impulse, the part of it
  // from resting contact, and the gap to a wall that is near but was not touched, replaced later by the allowed approach speed.
  wallCapacity: i32;
  wallCount: i32;
  wallDroppedCount: u32;
  wallBody: usize;
  wallId: usize;
  wallNx: usize;
  wallNy: usize;
  wallNz: usize;
  wallSpeed: usize;
  wallImpulse: usize;
  wallAccumulatedImpulse: usize;
  wallGap: usize;
  // Friction coefficient, the normal impulse for which friction has been applied, the friction impulse applied since
  // (three f32), and the slot of the body in `bodies`.
  wallFriction: usize;
  wallFrictionApplied: usize;
  wallTangentImpulse: usize;
  wallSlot: usize;
  // Resting contacts packed by batches into blocks of LANES (wide-contacts.ts), and the capacity of `batches` in keys.
  blocks: usize;
  batches: usize;
  maxBatches: i32;
  // Impacts in the list (impact-list.ts), one more than the capacity if some found no place, and its capacity, 0 if
  // none are to be noted.
  impactCount: i32;
  impactCapacity: i32;
  // Whether forces depend on position or velocity, so that elastic impacts act at the end of the step (impacts.ts).
  isUneven: i32;
  // Gathered bodies that have contacts, and their rows.
  bodies: usize;
  bodyRows: usize;
  bodyCount: i32;
  // Grid: one word per row, and the first body of each bucket. `starts` shares memory with `bodies`, which are gathered
  // later.
  rowWords: usize;
  starts: usize;
  // Bodies in bucket order, as columns. They share memory with the blocks, which are packed later.
  sortedX: usize;
  sortedY: usize;
  sortedZ: usize;
  sortedRadius: usize;
  sortedBucket: usize;
  sortedRow: usize;
  maxBuckets: i32;
  // Grid parameters of this step: bucket count (a power of two), distance in buckets between neighbours in y and in z,
  // number of bodies in the grid, number of bodies too large for it.
  buckets: i32;
  stride: i32;
  layer: i32;
  gridCount: i32;
  largeCount: i32;
  histogram: usize;
  // Scratch columns: velocity at the start of the step, position before the contact response.
  startX: usize;
  startY: usize;
  startZ: usize;
  fromX: usize;
  fromY: usize;
}

// Bytes of friction state per contact: the accumulated tangential impulse (three f32) and the friction coefficient.
export const FRICTION_STATE_SIZE: usize = 16;

// @ts-ignore: decorator
@inline export function frictionStateAt(t: ContactTable, i: i32): usize {
  return t.frictionState + <usize>i * FRICTION_STATE_SIZE;
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

// Larger than any valid result, and small enough not to overflow in the next operation.
export const FINITE: real = sizeof<real>() == 4 ? <real>1e37 : <real>1e300;

// Contacts are found up to this multiple of the radius or of the sum of the radii. Resting bodies keep their contact
// and its accumulated impulse while their separation is below this margin.
export const CONTACT_MARGIN: real = 1.01;

// Walls are recorded up to this multiple of the radius, because another body may press a body against the wall within
// the step.
export const WALL_MARGIN: real = 1.1;
