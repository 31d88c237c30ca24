// What to do about a fault that a step found: the second half of its sentence.
import type { FaultCode } from './physics-error';

const ADVICE: Partial<Record<FaultCode, string>> = {
  E_NONFINITE: 'Look at who wrote it: a force that divides by a distance or a mass of zero, or a value from outside.',
  E_RANGE: 'Look at who wrote it, or give the world units in which its lengths are smaller.',
  E_SPEED: 'Take shorter steps, or look for the force that made it so fast.',
  E_STIFF: 'Take shorter steps, softer springs, or the integrator implicitEuler() or xpbd().',
  E_STEP: 'A force is singular or jumps there: soften it, keep bodies apart, or take shorter steps.',
  E_CONVERGENCE: 'Take shorter steps, or for nets of very stiff springs the integrator xpbd().',
};

/** The advice for a fault's code, if there is any. */
export function adviceOn(code: FaultCode): string | undefined {
  return ADVICE[code];
}
