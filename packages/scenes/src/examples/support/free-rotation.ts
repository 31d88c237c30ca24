/** Rotation of a rigid body without a torque. Source: Landau and Lifshitz, Mechanics, § 37. */
import { agm } from './agm.ts';
import type { Point3 } from './space.ts';

/**
 * Period of the angular velocity about the middle axis, y, of a body with moments x < y < z: 4 K(k)/p, s.
 * @param spin angular velocity at one moment, in the body's axes, rad/s
 */
export function tumblingPeriod(moments: Point3, spin: Point3): number {
  const twiceEnergy = moments.x * spin.x * spin.x + moments.y * spin.y * spin.y + moments.z * spin.z * spin.z;
  const [lx, ly, lz] = [moments.x * spin.x, moments.y * spin.y, moments.z * spin.z];
  const momentum2 = lx * lx + ly * ly + lz * lz;
  // Where the axis of the largest moment is circled, the formulas hold as they are; otherwise x and z change places.
  const [low, high] = momentum2 > twiceEnergy * moments.y ? [moments.x, moments.z] : [moments.z, moments.x];
  const outer = (high - moments.y) * (momentum2 - twiceEnergy * low);
  const inner = (moments.y - low) * (twiceEnergy * high - momentum2);
  const rate = Math.sqrt(outer / (low * moments.y * high));
  return (2 * Math.PI) / (agm(1, Math.sqrt(1 - inner / outer)) * rate);
}
