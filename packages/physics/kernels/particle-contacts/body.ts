// A body as the response to contacts sees it: all it needs in one line of the cache (in f32). Bodies with contacts are
// gathered from their columns once a step, and written back once.
import { Columns, get, put } from '../memory/columns';
import { WALL_BODIES } from '../memory/low-memory-map';
import { ContactTable, FINITE, contactTable, putWord, word } from './table';

@unmanaged
export class Body {
  // Position and radius, then velocity and 1/m, 0 for a body that contacts do not move: quads.ts reads each as one.
  x: real;
  y: real;
  z: real;
  radius: real;
  vx: real;
  vy: real;
  vz: real;
  inverseMass: real;
  // Mean acceleration of the step; impulses are none.
  ax: real;
  ay: real;
  az: real;
  // r/I, 0 for a body that contacts do not turn.
  turning: real;
  // Angular velocity.
  wx: real;
  wy: real;
  wz: real;
  // Index + 1 of the contact with a wall that holds the body, 0 without one.
  wall: i32;
}

const SIZE: usize = (offsetof<Body>() + sizeof<real>() - 1) & ~(sizeof<real>() - 1);

// @ts-ignore: decorator
@inline export function nobody(): Body {
  return changetype<Body>(WALL_BODIES);
}

// @ts-ignore: decorator
@inline export function bodyAtWall(): Body {
  return changetype<Body>(WALL_BODIES + SIZE);
}

// @ts-ignore: decorator
@inline export function body(t: ContactTable, slot: i32): Body {
  return changetype<Body>(t.bodies + <usize>slot * SIZE);
}

// r/I of a body that contacts can turn: it has inertia and AngularVelocity.
// @ts-ignore: decorator
@inline function turningOf(c: Columns, row: i32): real {
  if ((word(c.members, row) & c.angularVelocityBit) == 0) return 0;
  const inertia = get(c.inertia, row);
  const ratio = get(c.radius, row) / inertia;
  return inertia > 0 && ratio < FINITE ? ratio : <real>0;
}

// Reads what friction at a wall needs.
export function readMotion(c: Columns, row: i32, to: Body): void {
  const mass = get(c.mass, row);
  to.vx = get(c.velocityX, row);
  to.vy = get(c.velocityY, row);
  to.vz = get(c.velocityZ, row);
  to.inverseMass = mass > 0 ? <real>1 / mass : <real>0;
  to.radius = get(c.radius, row);
  to.turning = turningOf(c, row);
  if (to.turning == 0) {
    to.wx = to.wy = to.wz = 0;
    return;
  }
  to.wx = get(c.angularVelocityX, row);
  to.wy = get(c.angularVelocityY, row);
  to.wz = get(c.angularVelocityZ, row);
}

export function writeMotion(c: Columns, row: i32, from: Body): void {
  put(c.velocityX, row, from.vx);
  put(c.velocityY, row, from.vy);
  put(c.velocityZ, row, from.vz);
  if (from.turning == 0) return;
  put(c.angularVelocityX, row, from.wx);
  put(c.angularVelocityY, row, from.wy);
  put(c.angularVelocityZ, row, from.wz);
}

// Gathers the bodies of the contacts in the order they come up, and notes for each contact where its two are.
export function gatherBodies(c: Columns, dt: real, lastId: i32): void {
  const t = contactTable();
  memory.fill(t.rowWords, 0, (<usize>(lastId + 1)) << 2);
  t.bodyCount = 0;
  const rate = <real>1 / dt;
  for (let i = 0; i < t.count; i++) {
    putWord(t.slotA, i, slotOf(c, t, word(t.a, i), rate));
    putWord(t.slotB, i, slotOf(c, t, word(t.b, i), rate));
  }
}

// @ts-ignore: decorator
@inline function slotOf(c: Columns, t: ContactTable, row: i32, rate: real): i32 {
  const known = word(t.rowWords, row);
  if (known > 0) return known - 1;
  const slot = t.bodyCount++;
  putWord(t.rowWords, row, slot + 1);
  putWord(t.bodyRows, slot, row);
  const to = body(t, slot);
  readMotion(c, row, to);
  to.x = get(c.positionX, row);
  to.y = get(c.positionY, row);
  to.ax = (to.vx - get(t.startX, row)) * rate;
  to.ay = (to.vy - get(t.startY, row)) * rate;
  // In 2D the grid has no layers; z is zero there and its columns stay untouched.
  to.z = t.layer == 0 ? <real>0 : get(c.positionZ, row);
  to.az = t.layer == 0 ? <real>0 : (to.vz - get(t.startZ, row)) * rate;
  to.wall = 0;
  return slot;
}

// Writes the bodies that can move back to their columns; with `remember`, notes where they were.
export function scatterBodies(c: Columns, t: ContactTable, remember: bool): void {
  for (let slot = 0; slot < t.bodyCount; slot++) {
    const from = body(t, slot);
    if (from.inverseMass == 0) continue;
    const row = word(t.bodyRows, slot);
    writeMotion(c, row, from);
    if (remember) {
      put(t.fromX, row, get(c.positionX, row));
      put(t.fromY, row, get(c.positionY, row));
    }
    put(c.positionX, row, from.x);
    put(c.positionY, row, from.y);
    if (t.layer != 0) put(c.positionZ, row, from.z);
  }
}

// Changes the velocity of a body by (dx, dy, dz), and its position by what that amounts to in `time`, the time since.
export function kick(b: Body, dx: real, dy: real, dz: real, time: real): void {
  b.vx += dx;
  b.vy += dy;
  b.vz += dz;
  b.x += dx * time;
  b.y += dy * time;
  b.z += dz * time;
}
