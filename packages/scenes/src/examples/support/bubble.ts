/** A bubble of warm air, which is a hundredth lighter than the air around it. */
import type { BodyInput } from '@principia/physics';

/** Acceleration at which gravity of 10 px/s² and buoyancy leave it, px/s². */
export const RISE = 10 * (1 / 0.99 - 1);

/** Mass (4/3)πr³, volume of a density of 0.99, and drag 0.01 πr², so that k/m is 0.0075/r. */
export function bubble(radius: number): BodyInput {
  const mass = (4 / 3) * Math.PI * radius * radius * radius;
  return { mass, hull: mass / 0.99, quadraticDrag: 0.01 * Math.PI * radius * radius, collider: radius };
}
