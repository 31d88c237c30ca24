import type { Integrator } from './types.ts';

/** The integrators that solve rigid bodies. */
const softSteps = new WeakSet<Integrator>();

/** Marks an integrator that solves rigid bodies, and returns it. */
export function markSoftStep(integrator: Integrator): Integrator {
  softSteps.add(integrator);
  return integrator;
}

/** Whether an integrator solves rigid bodies. */
export function isSoftStep(integrator: Integrator): boolean {
  return softSteps.has(integrator);
}
