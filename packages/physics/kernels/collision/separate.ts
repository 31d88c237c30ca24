// Takes bodies apart that overlap: a displacement, no velocity, so that nothing flies off that was put into another.
//
// Each contact asks for a part of the overlap that will not have gone by itself when the next step ends, shared by
// inverse mass, so that the centre of mass stays. No body is moved by more than `MOST_SPEED` radii a second: a heap of
// bodies in one place comes apart at a pace the eye can follow. The accelerations of the step have served by now, and
// their place takes the displacements.
import { get } from '../columns';
import { distance, readPlace } from './approach';
import { Body, body } from './body';
import { leave, leftX, leftY, leftZ, share } from './support';
import { ContactTable, putWord, word } from './table';

const PART: real = 0.5;
const MOST_SPEED: real = 4;

export function separate(t: ContactTable, dt: real): void {
  let count = 0;
  for (let i = 0; i < t.count; i++) {
    if (!(depthOf(t, i, dt) > 0)) continue;
    putWord(t.order, count++, i);
    clear(body(t, word(t.slotA, i)));
    clear(body(t, word(t.slotB, i)));
  }
  for (let k = 0; k < count; k++) push(t, word(t.order, k), dt);
  for (let k = 0; k < count; k++) {
    const i = word(t.order, k);
    move(body(t, word(t.slotA, i)), dt);
    move(body(t, word(t.slotB, i)), dt);
  }
}

// The overlap of contact i that will be left when the next step ends.
function depthOf(t: ContactTable, i: i32, dt: real): real {
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  readPlace(a, b);
  const overlap = a.radius + b.radius - distance;
  const speed = (b.vx - a.vx) * get(t.nx, i) + (b.vy - a.vy) * get(t.ny, i) + (b.vz - a.vz) * get(t.nz, i);
  return overlap - max<real>(0, speed * dt);
}

// @ts-ignore: decorator
@inline function clear(b: Body): void {
  b.ax = b.ay = b.az = 0;
}

function push(t: ContactTable, i: i32, dt: real): void {
  const a = body(t, word(t.slotA, i));
  const b = body(t, word(t.slotB, i));
  const x = get(t.nx, i);
  const y = get(t.ny, i);
  const z = get(t.nz, i);
  const depth = depthOf(t, i, dt);
  // A body that leaves its wall by less than this will not have room in the next step either.
  const slow = (<real>0.01 * depth) / dt;
  leave(t, a, -x, -y, -z, dt, slow);
  const ax = leftX;
  const ay = leftY;
  const az = leftZ;
  const sharing = a.inverseMass * share;
  leave(t, b, x, y, z, dt, slow);
  const sum = sharing + b.inverseMass * share;
  if (!(sum > 0)) return;
  const size = (PART * depth) / sum;
  add(a, ax, ay, az, size * a.inverseMass);
  add(b, leftX, leftY, leftZ, size * b.inverseMass);
}

// @ts-ignore: decorator
@inline function add(b: Body, x: real, y: real, z: real, size: real): void {
  b.ax += x * size;
  b.ay += y * size;
  b.az += z * size;
}

// Moves a body by its displacement, once.
function move(b: Body, dt: real): void {
  const length = sqrt<real>(b.ax * b.ax + b.ay * b.ay + b.az * b.az);
  if (!(length > 0)) return;
  const most = MOST_SPEED * b.radius * dt;
  const scale = length > most ? most / length : <real>1;
  b.x += b.ax * scale;
  b.y += b.ay * scale;
  b.z += b.az * scale;
  clear(b);
}
