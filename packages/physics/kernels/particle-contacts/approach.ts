// How the two bodies of a contact lie and move towards each other, at the end of the step as it is so far.
import { Body } from './body';

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

// @ts-ignore: decorator
@inline export function readPlace(a: Body, b: Body): void {
  dX = b.x - a.x;
  dY = b.y - a.y;
  dZ = b.z - a.z;
  distance = sqrt<real>(dX * dX + dY * dY + dZ * dZ);
}

// The normal of the place that was read, and the motions. `idA` and `idB` decide for two bodies in one place, `flat` in
// the plane; `lag` is the time by which the integrator's velocities lag its positions.
export function readApproach(a: Body, b: Body, idA: i32, idB: i32, flat: bool, lag: real): void {
  if (distance > 0) {
    nX = dX / distance;
    nY = dY / distance;
    nZ = dZ / distance;
  } else {
    chooseNormal(idA, idB, flat);
  }
  aX = b.ax - a.ax;
  aY = b.ay - a.ay;
  aZ = b.az - a.az;
  vX = b.vx - a.vx + lag * aX;
  vY = b.vy - a.vy + lag * aY;
  vZ = b.vz - a.vz + lag * aZ;
}

// A direction for two bodies in one place: any will do, but it must be the same in every run and differ from pair to
// pair. A hash of the ids gives a point of the circle (of the sphere) by its rational parametrisation.
function chooseNormal(a: i32, b: i32, flat: bool): void {
  let hash = <u32>a * 0x9e3779b1 + <u32>b * 0x85ebca77;
  hash = (hash ^ (hash >> 15)) * 0x2c1b3c6d;
  hash ^= hash >> 13;
  const u = <real>((hash >> 8) & 0xff) / <real>128 - <real>1;
  const v = flat ? <real>0 : <real>((hash >> 16) & 0xff) / <real>128 - <real>1;
  const sign: real = (hash & 1) == 0 ? 1 : -1;
  const square = u * u + v * v;
  nX = (sign * (<real>1 - square)) / (<real>1 + square);
  nY = (<real>2 * u) / (<real>1 + square);
  nZ = (<real>2 * v) / (<real>1 + square);
}
