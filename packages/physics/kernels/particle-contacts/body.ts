// The state of a body that the contact solver needs, packed into one cache line (in f32). Bodies with contacts are
// gathered from their columns once a step and written back once.
import { Columns, get, put } from '../memory/columns';
import { WALL_BODIES } from '../memory/low-memory-map';
import { ContactTable, FINITE, contactTable, putWord, word } from './table';

@unmanaged
export class Body {
  // Position and radius form one group of four, velocity and 1/m another: transpose4.ts loads each group as a unit. 1/m
  // is 0 for a body that contacts do not move.
  x: real;
  y: real;
  z: real;
  radius: real;
  vx: real;
  vy: real;
  vz: real;
  inverseMass: real;
  // Mean acceleration over the step; impulses do not count as acceleration.
  ax: real;
  ay: real;
  az: real;
  // r/I, or 0 for a body that contacts do not rotate.
  radiusOverInertia: real;
  // Angular velocity.
  wx: real;
  wy: real;
  wz: real;
  // Index + 1 of the wall contact that supports the body, or 0 if there is none.
  wall: i32;
}

const SIZE: usize = (offsetof<Body>() + sizeof<real>() - 1) & ~(sizeof<real>() - 1);

// @ts-ignore: decorator
@inline export function staticBody(): Body {
  return changetype<Body>(WALL_BODIES);
}

// @ts-ignore: decorator
@inline export function wallContactBody(): Body {
  return changetype<Body>(WALL_BODIES + SIZE);
}

// @ts-ignore: decorator
@inline export function body(t: ContactTable, slot: i32): Body {
  return changetype<Body>(t.bodies + <usize>slot * SIZE);
}

// Returns r/I of a body that contacts can rotate, which requires inertia and AngularVelocity; 0 otherwise.
// @ts-ignore: decorator
@inline function radiusOverInertia(c: Columns, row: i32): real {
  if ((word(c.members, row) & c.angularVelocityBit) == 0) return 0;
  const inertia = get(c.inertia, row);
  const ratio = get(c.radius, row) / inertia;
  return inertia > 0 && ratio < FINITE ? ratio : <real>0;
}

// Loads the fields that wall friction needs.
export function loadMotion(c: Columns, row: i32, to: Body): void {
  const mass = get(c.mass, row);
  to.vx = get(c.velocityX, row);
  to.vy = get(c.velocityY, row);
  to.vz = get(c.velocityZ, row);
  to.inverseMass = mass > 0 ? <real>1 / mass : <real>0;
  to.radius = get(c.radius, row);
  to.radiusOverInertia = radiusOverInertia(c, row);
  if (to.radiusOverInertia == 0) {
    to.wx = to.wy = to.wz = 0;
    return;
  }
  to.wx = get(c.angularVelocityX, row);
  to.wy = get(c.angularVelocityY, row);
  to.wz = get(c.angularVelocityZ, row);
}

export function storeMotion(c: Columns, row: i32, from: Body): void {
  put(c.velocityX, row, from.vx);
  put(c.velocityY, row, from.vy);
  put(c.velocityZ, row, from.vz);
  if (from.radiusOverInertia == 0) return;
  put(c.angularVelocityX, row, from.wx);
  put(c.angularVelocityY, row, from.wy);
  put(c.angularVelocityZ, row, from.wz);
}

// Gathers the bodies in the order in which the contacts list them, and stores the body slots of each contact.
export function gatherBodies(c: Columns, dt: real, lastId: i32): void {
  const t = contactTable();
  memory.fill(t.rowWords, 0, (<usize>(lastId + 1)) << 2);
  t.bodyCount = 0;
  const inverseDt = <real>1 / dt;
  for (let i = 0; i < t.count; i++) {
    putWord(t.slotA, i, slotOf(c, t, word(t.a, i), inverseDt));
    putWord(t.slotB, i, slotOf(c, t, word(t.b, i), inverseDt));
  }
}

// @ts-ignore: decorator
@inline function slotOf(c: Columns, t: ContactTable, row: i32, inverseDt: real): i32 {
  const slotPlusOne = word(t.rowWords, row);
  if (slotPlusOne > 0) return slotPlusOne - 1;
  const slot = t.bodyCount++;
  putWord(t.rowWords, row, slot + 1);
  putWord(t.bodyRows, slot, row);
  const to = body(t, slot);
  loadMotion(c, row, to);
  to.x = get(c.positionX, row);
  to.y = get(c.positionY, row);
  to.ax = (to.vx - get(t.startX, row)) * inverseDt;
  to.ay = (to.vy - get(t.startY, row)) * inverseDt;
  // In 2D the grid has no layers; z is zero and its columns are not accessed.
  to.z = t.layer == 0 ? <real>0 : get(c.positionZ, row);
  to.az = t.layer == 0 ? <real>0 : (to.vz - get(t.startZ, row)) * inverseDt;
  to.wall = 0;
  return slot;
}

// Writes the movable bodies back to their columns. With `savePositions` the previous positions are saved first.
export function scatterBodies(c: Columns, t: ContactTable, savePositions: bool): void {
  for (let slot = 0; slot < t.bodyCount; slot++) {
    const from = body(t, slot);
    if (from.inverseMass == 0) continue;
    const row = word(t.bodyRows, slot);
    storeMotion(c, row, from);
    if (savePositions) {
      put(t.fromX, row, get(c.positionX, row));
      put(t.fromY, row, get(c.positionY, row));
    }
    put(c.positionX, row, from.x);
    put(c.positionY, row, from.y);
    if (t.layer != 0) put(c.positionZ, row, from.z);
  }
}

// Changes the velocity of a body by (dx, dy, dz), and its position by the displacement that this change caused in the
// `time` since the impact.
export function applyVelocityChange(b: Body, dx: real, dy: real, dz: real, time: real): void {
  b.vx += dx;
  b.vy += dy;
  b.vz += dz;
  b.x += dx * time;
  b.y += dy * time;
  b.z += dz * time;
}
