/** The exact period of a pendulum, for every amplitude. */
import { cos } from '@principia/physics';
import { agm } from './agm.ts';

/** 2π √(L/g) divided by the arithmetic-geometric mean of 1 and cos(φ/2), with the amplitude φ in degrees. */
export function pendulumPeriod(length: number, gravity: number, degrees: number): number {
  return (2 * Math.PI * Math.sqrt(length / gravity)) / agm(1, cos((degrees * Math.PI) / 360));
}
