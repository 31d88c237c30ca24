// Default hints for faults that any step may find; integrators supply hints for their own faults.
import type { FaultCode } from './physics-error.ts';

/** Hints by fault code. */
export const FAULT_HINTS: Partial<Record<FaultCode, string>> = {
  E_NONFINITE:
    'Check your code that writes it, such as a force that divides by zero. If there is none, Principia is wrong.',
  E_RANGE: 'Check the code that writes it, or choose larger units of length.',
  E_SPEED: 'Use a smaller dt, or check the force that accelerates the body.',
};
