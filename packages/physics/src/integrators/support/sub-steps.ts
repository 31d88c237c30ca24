import { reportFault } from '../../errors/report-fault.ts';
import { checkWhole } from '../../errors/validate.ts';
import type { PhysicsWorld } from '../../world/types.ts';

// Shared by schemes with adaptive sub-steps, which divide the world's step.
/** Minimum sub-step as a fraction of the step: below it a force is singular or discontinuous. */
export const MIN_SUB_STEP = 1e-10;

/** Maximum number of force evaluations per body and step: a fifth of a second on a machine of 2024. */
const BODY_EVALUATIONS = 1e7;

/** Default maximum of evaluations of all forces per step: fewer for many bodies, at most 125 000. */
export function defaultEvaluations({ internal }: PhysicsWorld): number {
  return Math.ceil(BODY_EVALUATIONS / Math.max(80, internal.bodyList.count));
}

/** @throws PhysicsError E_TYPE, E_RANGE if the budget is not an integer from 100 to 1e9 */
export function checkEvaluations(value: unknown): number | undefined {
  return value === undefined ? undefined : checkWhole(value as number, 'maxEvaluations', 100, 1e9);
}

/** Number of sub-steps without error control that complete a step after a failure. */
export const FALLBACK_STEPS = 16;

/** Returns the next sub-step: as long as suggested, but leaves no tiny remainder at the end of the step. */
export function subStep(suggested: number, remaining: number): number {
  if (suggested >= remaining) return remaining;
  return 2 * suggested > remaining ? remaining / 2 : suggested;
}

/** Reports that the tolerance was not met, and the body that needed a step of `suggested` seconds. */
export function reportUnderflow(world: PhysicsWorld, entity: number, suggested: number): void {
  reportFault(world, {
    code: 'E_STEP',
    entity,
    field: 'Position',
    value: suggested,
    phase: 'integrate',
    hint: 'A force is singular, stiff or jumps there: soften it, take shorter steps, or allow more maxEvaluations.',
  });
}
