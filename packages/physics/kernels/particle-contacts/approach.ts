// Relative position and motion of the two bodies of a contact, with the values that the step has reached so far.
import { Body } from './body';

// All vectors point from a to b: relative position d, velocity v, mean acceleration a over the step, and the unit
// normal n. `distance` is between the centres.
@unmanaged
class Approach {
  x: real;
  y: real;
  z: real;
  vx: real;
  vy: real;
  vz: real;
  ax: real;
  ay: real;
  az: real;
  nx: real;
  ny: real;
  nz: real;
  distance: real;
}

// Results of the last calls of `readSeparation` and `readRelativeMotion`.
export const approach = changetype<Approach>(memory.data(offsetof<Approach>(), 8));

// @ts-ignore: decorator
@inline export function readSeparation(a: Body, b: Body): void {
  const x = b.x - a.x;
  const y = b.y - a.y;
  const z = b.z - a.z;
  approach.x = x;
  approach.y = y;
  approach.z = z;
  approach.distance = sqrt<real>(x * x + y * y + z * z);
}

// Computes the unit normal from the separation read last, and the relative motion. The ids choose the normal of two
// bodies at the same point; `flat` restricts it to the plane. `lag` is the time by which the integrator's velocities
// lag its positions.
export function readRelativeMotion(a: Body, b: Body, idA: i32, idB: i32, flat: bool, lag: real): void {
  const distance = approach.distance;
  if (distance > 0) {
    approach.nx = approach.x / distance;
    approach.ny = approach.y / distance;
    approach.nz = approach.z / distance;
  } else {
    chooseNormal(idA, idB, flat);
  }
  const ax = b.ax - a.ax;
  const ay = b.ay - a.ay;
  const az = b.az - a.az;
  approach.ax = ax;
  approach.ay = ay;
  approach.az = az;
  approach.vx = b.vx - a.vx + lag * ax;
  approach.vy = b.vy - a.vy + lag * ay;
  approach.vz = b.vz - a.vz + lag * az;
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
  approach.nx = (sign * (<real>1 - square)) / (<real>1 + square);
  approach.ny = (<real>2 * u) / (<real>1 + square);
  approach.nz = (<real>2 * v) / (<real>1 + square);
}
