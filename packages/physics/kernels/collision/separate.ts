// Takes bodies apart that overlap: a displacement, no velocity, so that nothing flies off that was put into another.
//
// Each contact asks for a part of the overlap that will not have gone by itself when the next step ends, shared by
// inverse mass, so that the centre of mass stays. No body is moved by more than `MOST_SPEED` radii a second: a heap of
// bodies in one place comes apart at a pace the eye can follow.
import { Columns, get, put } from '../columns';
import { inverseMass } from './friction';
import { leave, leftX, leftY, leftZ, share } from './support';
import { ContactTable, word } from './table';

const PART: real = 0.5;
const MOST_SPEED: real = 4;

export function separate(c: Columns, t: ContactTable, dt: real): void {
  for (let i = 0; i < t.count; i++) {
    clear(t, word(t.a, i));
    clear(t, word(t.b, i));
  }
  let any = false;
  for (let i = 0; i < t.count; i++) any = push(c, t, i, dt) || any;
  if (!any) return;
  for (let i = 0; i < t.count; i++) {
    move(c, t, word(t.a, i), dt);
    move(c, t, word(t.b, i), dt);
  }
}

// @ts-ignore: decorator
@inline function clear(t: ContactTable, row: i32): void {
  put(t.pushX, row, 0);
  put(t.pushY, row, 0);
  put(t.pushZ, row, 0);
}

function push(c: Columns, t: ContactTable, i: i32, dt: real): bool {
  const a = word(t.a, i);
  const b = word(t.b, i);
  const x = get(t.nx, i);
  const y = get(t.ny, i);
  const z = get(t.nz, i);
  const dx = get(c.positionX, b) - get(c.positionX, a);
  const dy = get(c.positionY, b) - get(c.positionY, a);
  const dz = get(c.positionZ, b) - get(c.positionZ, a);
  const overlap = get(c.radius, a) + get(c.radius, b) - sqrt<real>(dx * dx + dy * dy + dz * dz);
  if (!(overlap > 0)) return false;
  const speed =
    (get(c.velocityX, b) - get(c.velocityX, a)) * x +
    (get(c.velocityY, b) - get(c.velocityY, a)) * y +
    (get(c.velocityZ, b) - get(c.velocityZ, a)) * z;
  const depth = overlap - max<real>(0, speed * dt);
  if (!(depth > 0)) return false;
  // A body that leaves its wall by less than this will not have room in the next step either.
  const slow = (<real>0.01 * depth) / dt;
  leave(c, t, a, -x, -y, -z, dt, slow);
  const wa = inverseMass(c, a);
  const ax = leftX;
  const ay = leftY;
  const az = leftZ;
  const shareA = wa * share;
  leave(c, t, b, x, y, z, dt, slow);
  const wb = inverseMass(c, b);
  const sum = shareA + wb * share;
  if (!(sum > 0)) return false;
  const size = (PART * depth) / sum;
  add(t, a, ax, ay, az, size * wa);
  add(t, b, leftX, leftY, leftZ, size * wb);
  return true;
}

// @ts-ignore: decorator
@inline function add(t: ContactTable, row: i32, x: real, y: real, z: real, size: real): void {
  put(t.pushX, row, get(t.pushX, row) + x * size);
  put(t.pushY, row, get(t.pushY, row) + y * size);
  put(t.pushZ, row, get(t.pushZ, row) + z * size);
}

function move(c: Columns, t: ContactTable, row: i32, dt: real): void {
  const x = get(t.pushX, row);
  const y = get(t.pushY, row);
  const z = get(t.pushZ, row);
  const length = sqrt<real>(x * x + y * y + z * z);
  if (!(length > 0)) return;
  const most = MOST_SPEED * get(c.radius, row) * dt;
  const scale = length > most ? most / length : <real>1;
  put(c.positionX, row, get(c.positionX, row) + x * scale);
  put(c.positionY, row, get(c.positionY, row) + y * scale);
  put(c.positionZ, row, get(c.positionZ, row) + z * scale);
  clear(t, row);
}
