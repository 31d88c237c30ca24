import { reportFault } from '../../errors/report-fault.ts';
import { checkWhole } from '../../errors/validate.ts';
import type { PhysicsWorld } from '../../world/types.ts';

// Shared by schemes with adaptive sub-steps, which divide the world's step.
/** Minimum sub-step as a fraction of the step: below it a force is singular or discontinuous. */
export const MIN_SUB_STEP = 1e-10;

/** Evaluations of a simple force on one body, of some 20 ns, that a step may take: a sixth of a second. */
const BODY_EVALUATIONS = 8e6;

/** What every evaluation may take at least, so that a step of ordinary length is possible with any number of bodies. */
const MIN_EVALUATIONS = 100;

/**
 * Default maximum of evaluations of all forces per step: fewer for many bodies and for forces between all of them, at
 * most 100 000.
 * @param ownWork work of the integrator itself per evaluation and body, in evaluations of a simple force
 */
export function defaultEvaluations(world: PhysicsWorld, ownWork: number): number {
  let work = ownWork * Math.max(80, world.internal.bodyList.count);
  for (const force of world.forces) work += force.evaluationWork?.(world) ?? 0;
  return Math.max(MIN_EVALUATIONS, Math.ceil(BODY_EVALUATIONS / work));
}

/** @throws PhysicsError E_TYPE, E_RANGE if the budget is not an integer from 100 to 1e9 */
export function checkEvaluations(value: unknown): number | undefined {
  return value === undefined ? undefined : checkWhole(value as number, 'maxEvaluations', 100, 1e9);
}

/** Maximum number of sub-steps without error control that complete a step after a failure. */
const FALLBACK_STEPS = 16;

/** Returns the number of sub-steps that complete a step after a failure, which shall not take longer than the rest. */
export function fallbackStepCount(budget: number, evaluationsPerStep: number): number {
  return Math.min(FALLBACK_STEPS, Math.ceil(budget / (2 * evaluationsPerStep)));
}

/** Returns the next sub-step: as long as suggested, but leaves no tiny remainder at the end of the step. */
export function subStep(suggested: number, remaining: number): number {
  if (suggested >= remaining) return remaining;
  return 2 * suggested > remaining ? remaining / 2 : suggested;
}

/** Reports that the tolerance was not met, and the body that needed a sub-step of `suggested` seconds. */
export function reportUnderflow(world: PhysicsWorld, entity: number, suggested: number): void {
  reportFault(world, {
    code: 'E_STEP',
    entity,
    field: 'sub-step',
    value: suggested,
    phase: 'integrate',
    hint: 'A force is singular, stiff or jumps there: soften it, take shorter steps, or allow more maxEvaluations.',
  });
}
