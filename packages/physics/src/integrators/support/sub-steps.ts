import { reportFault } from '../../errors/report-fault.ts';
import { checkWhole } from '../../errors/validate.ts';
import type { PhysicsWorld } from '../../world/types.ts';

// What schemes that choose their own steps share: they divide the world's step so that it ends where it should.
/** A sub-step below this part of the step is no step any more: something is singular or jumps. */
export const SHORTEST = 1e-10;

/** Evaluations of a body's forces in a step before it is given up: a fifth of a second on a machine of 2024. */
const BODY_EVALUATIONS = 1e7;

/** Evaluations of all forces in one step, by default: fewer where there are many bodies, at most 125 000. */
export function defaultEvaluations({ internal }: PhysicsWorld): number {
  return Math.ceil(BODY_EVALUATIONS / Math.max(80, internal.bodyList.count));
}

/** @throws PhysicsError E_TYPE, E_RANGE for a budget that is no whole number */
export function checkEvaluations(value: unknown): number | undefined {
  return value === undefined ? undefined : checkWhole(value as number, 'maxEvaluations', 100, 1e9);
}

/** Sub-steps without error control that cross the rest of a step that was given up. */
export const LAST_RESORT = 16;

/** The next sub-step: as long as the scheme wants, but no tiny one is left over at the end. */
export function subStep(wanted: number, rest: number): number {
  if (wanted >= rest) return rest;
  return 2 * wanted > rest ? rest / 2 : wanted;
}

/** Enters into the log that the tolerance was not kept, and which body would have needed a step of `wanted` seconds. */
export function reportUnderflow(world: PhysicsWorld, entity: number, wanted: number): void {
  reportFault(world, {
    code: 'E_STEP',
    entity,
    field: 'Position',
    value: wanted,
    phase: 'integrate',
    hint: 'A force is singular, stiff or jumps there: soften it, take shorter steps, or allow more maxEvaluations.',
  });
}
