/** The exact period of a pendulum, for every amplitude. */
import { cos } from '@principia/physics';

/** 2π √(L/g) divided by the arithmetic-geometric mean of 1 and cos(φ/2), with the amplitude φ in degrees. */
export function pendulumPeriod(length: number, gravity: number, degrees: number): number {
  let [a, b] = [1, cos((degrees * Math.PI) / 360)];
  for (let i = 0; i < 8; i++) [a, b] = [(a + b) / 2, Math.sqrt(a * b)];
  return (2 * Math.PI * Math.sqrt(length / gravity)) / a;
}
