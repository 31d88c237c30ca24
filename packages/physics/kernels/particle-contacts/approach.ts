// Relative position and motion of the two bodies of a contact, with the values that the step has reached so far.
import { Body } from './body';

// All vectors point from a to b: relative position d, velocity v, mean acceleration a over the step, and the unit
// normal n. `distance` is between the centres.
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
@inline export function readSeparation(a: Body, b: Body): void {
  dX = b.x - a.x;
  dY = b.y - a.y;
  dZ = b.z - a.z;
  distance = sqrt<real>(dX * dX + dY * dY + dZ * dZ);
}

// Computes the unit normal from the separation read last, and the relative motion. The ids choose the normal of two
// bodies at the same point; `flat` restricts it to the plane. `lag` is the time by which the integrator's velocities
// lag its positions.
export function readRelativeMotion(a: Body, b: Body, idA: i32, idB: i32, flat: bool, lag: real): void {
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

// Returns a normal for two bodies whose centres coincide. Any direction is valid, but it must be the same in every run
// and differ between pairs. A hash of the ids selects a point on the circle (or sphere) by its rational
// parametrisation.
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
