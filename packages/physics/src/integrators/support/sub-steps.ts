import { reportFault } from '../../errors/report-fault.ts';
import type { PhysicsWorld } from '../../world/types.ts';

// Shared by schemes with adaptive sub-steps, which divide the world's step.
/** Minimum sub-step as a fraction of the step: below it a force is singular or discontinuous. */
export const MIN_SUB_STEP = 1e-10;

/** Maximum number of attempted sub-steps per step. */
export const MAX_TRIES = 100_000;

/** Number of sub-steps without error control that complete a step after a failure. */
export const FALLBACK_STEPS = 16;

/** Returns the next sub-step: as long as wanted, but leaves no tiny remainder at the end of the step. */
export function subStep(wanted: number, rest: number): number {
  if (wanted >= rest) return rest;
  return 2 * wanted > rest ? rest / 2 : wanted;
}

/** Reports that the tolerance was not met, and the body that needed a step of `wanted` seconds. */
export function reportUnderflow(world: PhysicsWorld, entity: number, wanted: number): void {
  reportFault(world, {
    code: 'E_STEP',
    entity,
    field: 'Position',
    value: wanted,
    phase: 'integrate',
    hint: 'A force is singular or jumps there: soften it, keep bodies apart, or take shorter steps.',
  });
}
