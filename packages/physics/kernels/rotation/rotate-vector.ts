// Rotation of a vector by a unit quaternion, in f64: v + 2 u × (u × v + w v), u the vector part of the quaternion.
// Source: Kuipers, Quaternions and Rotation Sequences, section 5.15.

// The x component of the vector (a, b, c) rotated by (x, y, z, w). Cyclic exchange of x, y, z and of a, b, c gives the
// other components; -w gives the inverse rotation. It is not inlined: its many copies would weigh two kilobytes.
export function rotatedX(x: f64, y: f64, z: f64, w: f64, a: f64, b: f64, c: f64): f64 {
  const ty = z * a - x * c + w * b;
  const tz = x * b - y * a + w * c;
  return a + 2 * (y * tz - z * ty);
}
