// The rotation of the body that an emitter follows, and the place and velocity of its nozzle, at the moment of a birth.
import { arcTangent2 } from '../math/elementary';
import { Emitter } from './record';

@unmanaged
class Rotated {
  x: f64;
  y: f64;
  z: f64;
}

// The result of the last `rotate`.
export const rotated = changetype<Rotated>(memory.data(offsetof<Rotated>(), 8));

let x: f64 = 0;
let y: f64 = 0;
let z: f64 = 0;
let w: f64 = 1;

// Sets the rotation for a birth at the fraction `t` of the time since the last step, between the two rotations of the
// record by the shorter way (normalised linear interpolation).
export function turnTo(e: Emitter, t: f64): void {
  if (e.turns == 0) return;
  const cosine = e.turnX * e.lastTurnX + e.turnY * e.lastTurnY + e.turnZ * e.lastTurnZ + e.turnW * e.lastTurnW;
  const last = cosine < 0 ? t - 1 : 1 - t;
  x = e.lastTurnX * last + e.turnX * t;
  y = e.lastTurnY * last + e.turnY * t;
  z = e.lastTurnZ * last + e.turnZ * t;
  w = e.lastTurnW * last + e.turnW * t;
  const scale = 1 / sqrt<f64>(x * x + y * y + z * z + w * w);
  x *= scale;
  y *= scale;
  z *= scale;
  w *= scale;
}

// Rotates a vector from the frame of the emitter into the world: v + 2 w (u x v) + 2 u x (u x v), where u is the vector
// part of the quaternion.
export function rotate(e: Emitter, vx: f64, vy: f64, vz: f64): void {
  rotated.x = vx;
  rotated.y = vy;
  rotated.z = vz;
  if (e.turns == 0) return;
  const cx = 2 * (y * vz - z * vy);
  const cy = 2 * (z * vx - x * vz);
  const cz = 2 * (x * vy - y * vx);
  rotated.x += w * cx + (y * cz - z * cy);
  rotated.y += w * cy + (z * cx - x * cz);
  rotated.z += w * cz + (x * cy - y * cx);
}

// What the turning of the nozzle adds to the place of births between the last step's and this one's, and to its mean
// velocity, after `placeNozzle`.
export let nozzleX: f64 = 0;
export let nozzleY: f64 = 0;
export let nozzleZ: f64 = 0;
export let nozzleU: f64 = 0;
export let nozzleV: f64 = 0;
export let nozzleW: f64 = 0;

// The rotated offset at the last step, its change since, and the angular velocity times the inherited fraction.
let armX: f64 = 0;
let armY: f64 = 0;
let armZ: f64 = 0;
let sweepX: f64 = 0;
let sweepY: f64 = 0;
let sweepZ: f64 = 0;
let spinX: f64 = 0;
let spinY: f64 = 0;
let spinZ: f64 = 0;

// Prepares `placeNozzle` for the births of a step.
export function beginNozzle(e: Emitter): void {
  if (e.turns == 0) {
    nozzleX = nozzleY = nozzleZ = nozzleU = nozzleV = nozzleW = 0;
    return;
  }
  turnTo(e, 0);
  rotate(e, e.offsetX, e.offsetY, e.offsetZ);
  armX = rotated.x;
  armY = rotated.y;
  armZ = rotated.z;
  turnTo(e, 1);
  rotate(e, e.offsetX, e.offsetY, e.offsetZ);
  sweepX = rotated.x - armX;
  sweepY = rotated.y - armY;
  sweepZ = rotated.z - armZ;
  // The rotation since the last step, q1 q0*, by the shorter way.
  const cosine = e.turnX * e.lastTurnX + e.turnY * e.lastTurnY + e.turnZ * e.lastTurnZ + e.turnW * e.lastTurnW;
  spinX = e.lastTurnW * e.turnX - e.turnW * e.lastTurnX - (e.turnY * e.lastTurnZ - e.turnZ * e.lastTurnY);
  spinY = e.lastTurnW * e.turnY - e.turnW * e.lastTurnY - (e.turnZ * e.lastTurnX - e.turnX * e.lastTurnZ);
  spinZ = e.lastTurnW * e.turnZ - e.turnW * e.lastTurnZ - (e.turnX * e.lastTurnY - e.turnY * e.lastTurnX);
  const sine = sqrt<f64>(spinX * spinX + spinY * spinY + spinZ * spinZ);
  const angle = 2 * arcTangent2(cosine < 0 ? -sine : sine, abs<f64>(cosine));
  const scale = sine > 0 && e.pending > 0 ? (angle / sine) * (e.inheritVelocity / e.pending) : 0;
  spinX *= scale;
  spinY *= scale;
  spinZ *= scale;
}

// Turns the nozzle for a birth at the fraction `t` of the time since the last step: the body goes straight on at its mean
// velocity V, and the arm r turns about it, v = V + w x r.
export function placeNozzle(e: Emitter, t: f64): void {
  if (e.turns == 0) return;
  turnTo(e, t);
  rotate(e, e.offsetX, e.offsetY, e.offsetZ);
  const mean = e.pending > 0 ? e.inheritVelocity / e.pending : 0;
  nozzleX = rotated.x - (armX + sweepX * t);
  nozzleY = rotated.y - (armY + sweepY * t);
  nozzleZ = rotated.z - (armZ + sweepZ * t);
  nozzleU = spinY * rotated.z - spinZ * rotated.y - mean * sweepX;
  nozzleV = spinZ * rotated.x - spinX * rotated.z - mean * sweepY;
  nozzleW = spinX * rotated.y - spinY * rotated.x - mean * sweepZ;
}
