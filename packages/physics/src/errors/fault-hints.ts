// What to do about a fault that any step may find; integrators say it of their own.
import type { FaultCode } from './physics-error.ts';

/** By a fault's code. */
export const FAULT_HINTS: Partial<Record<FaultCode, string>> = {
  E_NONFINITE: 'Look at who wrote it: a force that divides by a distance or a mass of zero, or a value from outside.',
  E_RANGE: 'Look at who wrote it, or give the world units in which its lengths are smaller.',
  E_SPEED: 'Take shorter steps, or look for the force that made it so fast.',
};
