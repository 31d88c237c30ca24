// A pair of shapes whose fat boxes overlap, from the step in which they begin to until they no longer do. It keeps the
// manifold and its impulses, from which the next step starts.
import { word } from '../../../solver/2d/body';
import { RigidTable } from '../../../solver/2d/rigid-table';
import { EDGE_OF_A, EDGE_OF_B } from './manifold';

@unmanaged
export class RigidContact {
  // Rows of the shapes, a < b, and of the bodies that they belong to (solver/2d/parts.ts). Then what the contact was made
  // for: generations of the rows, and the indices of their shapes.
  a: i32;
  b: i32;
  bodyA: i32;
  bodyB: i32;
  generationA: u32;
  generationB: u32;
  shapeA: u32;
  shapeB: u32;
  flags: u32;
  // Points of the manifold, 0 to 2, and their feature ids, two bytes each.
  count: i16;
  id0: u16;
  id1: u16;
  friction: real;
  restitution: real;
  rollingResistance: real;
  tangentSpeed: real;
  rollingImpulse: real;
  // Poses when the manifold was found: rotations, and the position of b from a. Then its unit normal.
  ac: real;
  as: real;
  bc: real;
  bs: real;
  dx: real;
  dy: real;
  foundNx: real;
  foundNy: real;
  // Unit normal from a to b.
  nx: real;
  ny: real;
  // How far one may slide along the other until other corners take part (manifold.ts).
  room: real;
  // Two points, class ContactPoint: each has this many reals.
  point0: real;
}

// A point as it was found: anchors from the centres of mass of both bodies, and separation. Then as it is in this step, and the
// impulses.
@unmanaged
export class ContactPoint {
  foundAx: real;
  foundAy: real;
  foundBx: real;
  foundBy: real;
  foundSeparation: real;
  ax: real;
  ay: real;
  bx: real;
  by: real;
  separation: real;
  normalImpulse: real;
  tangentImpulse: real;
  // The sum of all sub-steps, N s, and the speed along the normal before the step, m/s.
  totalImpulse: real;
  normalSpeed: real;
}

const POINT: usize = 14 * sizeof<real>();

// @ts-ignore: decorator
@inline export const RIGID_CONTACT_SIZE: usize = (offsetof<RigidContact>('point0') + 2 * POINT + 15) & ~15;

// Bits of `flags`, and how long they last. What is of one step is found anew in each that looks at the contact, from what it was.
//
//   TOUCHING, WAS_TOUCHING     a step; the second is the first of the step before
//   FOUND                      as long as the manifold may be kept
//   PASSING                    a step; while the shapes meet it follows from that of the step before
//   SENSES, SENSOR_IS_B        as long as the same shape is a sensor; of the others only FOUND and the next two go with them
//   OVERLAPS, DID_OVERLAP      a step; the second is the first of the step before
//   IGNORED                    as long as the contact
//   COVERED                    a step
//   IS_DEEP                    until the depth of the contact is looked at again
//   FORESEEN, FAST_POINT       a step
//   EDGE_OF_A, EDGE_OF_B       as long as the manifold, whose they are (manifold.ts): 8192, 16384
//   ON_CHAIN, CORNERS          as long as the manifold
//   IS_DEEP_PAIR               a step
//
// The shapes touch now, and did in the step before; the manifold was found and may be kept.
export const TOUCHING: u32 = 1;
export const WAS_TOUCHING: u32 = 2;
export const FOUND: u32 = 4;
// It passes through a one-way platform.
export const PASSING: u32 = 8;
// One of the shapes is a sensor, a or b; they overlap now, and did in the step before.
export const SENSES: u32 = 16;
export const SENSOR_IS_B: u32 = 32;
export const OVERLAPS: u32 = 64;
export const DID_OVERLAP: u32 = 128;
// A function of the user keeps the two from colliding.
export const IGNORED: u32 = 256;
// Another contact of the same body holds it already, so that this one does nothing (seams.ts).
export const COVERED: u32 = 512;
// Two bodies that move overlap deeply (solver/2d/crowds.ts).
export const IS_DEEP: u32 = 1024;
// The manifold is that of the moment in this step at which the shapes will meet (collide-ahead.ts).
export const FORESEEN: u32 = 2048;
// A point approached faster than the hit speed when the step began.
export const FAST_POINT: u32 = 4096;
// EDGE_OF_A and EDGE_OF_B: the only point is a corner of b on an edge of a, or the other way round.
// One of the shapes is a segment of a chain, which ends where the next one begins.
export const ON_CHAIN: u32 = 32768;
// Whose corners the points are: FIRST_OF_B, SECOND_OF_B and KNOWN of manifold.ts from this bit on.
export const CORNERS_SHIFT: u32 = 16;
export const CORNERS: u32 = 7 << CORNERS_SHIFT;
// It is deep, has two points, and neither body touches anything else (solver/2d/deep-pairs.ts).
export const IS_DEEP_PAIR: u32 = 1 << 19;

// What goes with the manifold, and what a contact that collides has from the step before.
export const OF_MANIFOLD: u32 = EDGE_OF_A | EDGE_OF_B | ON_CHAIN | CORNERS;
export const KEPT: u32 = FOUND | IS_DEEP | OF_MANIFOLD;

// @ts-ignore: decorator
@inline export function contactAt(t: RigidTable, slot: i32): RigidContact {
  return changetype<RigidContact>(t.contacts + <usize>slot * RIGID_CONTACT_SIZE);
}

// In the list of contacts, beside the number of the record: the contact was looked at when neither shape moved, and that changed nothing.
export const SETTLED: i32 = 1 << 31;

// @ts-ignore: decorator
@inline export function isSettled(t: RigidTable, i: i32): bool {
  return (word(t.order, i) & SETTLED) != 0;
}

// The number of the record of the i-th contact in the order of (a, b).
// @ts-ignore: decorator
@inline export function slotInOrder(t: RigidTable, i: i32): i32 {
  return word(t.order, i) & ~SETTLED;
}

// @ts-ignore: decorator
@inline export function contactInOrder(t: RigidTable, i: i32): RigidContact {
  return contactAt(t, slotInOrder(t, i));
}

// @ts-ignore: decorator
@inline export function pointOf(contact: RigidContact, i: i32): ContactPoint {
  return changetype<ContactPoint>(changetype<usize>(contact) + offsetof<RigidContact>('point0') + <usize>i * POINT);
}
