// The rotation of the body that an emitter follows, at the moment of a birth.
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
