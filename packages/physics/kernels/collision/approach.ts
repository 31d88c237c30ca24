// How the two bodies of a contact lie and move towards each other, at the end of the step as it is so far.
import { Columns, get } from '../columns';
import { ContactTable } from './table';

// From a to b: position, velocity, mean acceleration of the step; the unit normal and the distance of the centres.
export let dX: real = 0;
export let dY: real = 0;
export let dZ: real = 0;
export let vX: real = 0;
export let vY: real = 0;
export let vZ: real = 0;
export let aX: real = 0;
export let aY: real = 0;
export let aZ: real = 0;
export let nX: real = 0;
export let nY: real = 0;
export let nZ: real = 0;
export let distance: real = 0;
// Largest acceleration of the two, squared.
export let accelerationSquare: real = 0;

// `rate` is 1/dt; `lag` the time by which the integrator's velocities lag its positions.
export function readApproach(c: Columns, t: ContactTable, a: i32, b: i32, rate: real, lag: real): void {
  dX = get(c.positionX, b) - get(c.positionX, a);
  dY = get(c.positionY, b) - get(c.positionY, a);
  dZ = get(c.positionZ, b) - get(c.positionZ, a);
  const ax = (get(c.velocityX, a) - get(t.startX, a)) * rate;
  const ay = (get(c.velocityY, a) - get(t.startY, a)) * rate;
  const az = (get(c.velocityZ, a) - get(t.startZ, a)) * rate;
  const bx = (get(c.velocityX, b) - get(t.startX, b)) * rate;
  const by = (get(c.velocityY, b) - get(t.startY, b)) * rate;
  const bz = (get(c.velocityZ, b) - get(t.startZ, b)) * rate;
  accelerationSquare = max<real>(ax * ax + ay * ay + az * az, bx * bx + by * by + bz * bz);
  aX = bx - ax;
  aY = by - ay;
  aZ = bz - az;
  vX = get(c.velocityX, b) - get(c.velocityX, a) + lag * aX;
  vY = get(c.velocityY, b) - get(c.velocityY, a) + lag * aY;
  vZ = get(c.velocityZ, b) - get(c.velocityZ, a) + lag * aZ;
  distance = sqrt<real>(dX * dX + dY * dY + dZ * dZ);
  if (distance > 0) {
    nX = dX / distance;
    nY = dY / distance;
    nZ = dZ / distance;
  } else {
    chooseNormal(t, a, b);
  }
}

// A direction for two bodies in one place: any will do, but it must be the same in every run and differ from pair to
// pair. A hash of the ids gives a point of the circle (of the sphere) by its rational parametrisation.
function chooseNormal(t: ContactTable, a: i32, b: i32): void {
  let hash = <u32>a * 0x9e3779b1 + <u32>b * 0x85ebca77;
  hash = (hash ^ (hash >> 15)) * 0x2c1b3c6d;
  hash ^= hash >> 13;
  const u = <real>((hash >> 8) & 0xff) / <real>128 - <real>1;
  const v = t.layer == 0 ? <real>0 : <real>((hash >> 16) & 0xff) / <real>128 - <real>1;
  const sign: real = (hash & 1) == 0 ? 1 : -1;
  const square = u * u + v * v;
  nX = (sign * (<real>1 - square)) / (<real>1 + square);
  nY = (<real>2 * u) / (<real>1 + square);
  nZ = (<real>2 * v) / (<real>1 + square);
}
