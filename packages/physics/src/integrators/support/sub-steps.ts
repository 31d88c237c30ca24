import { reportFault } from '../../errors/report-fault.ts';
import type { PhysicsWorld } from '../../world/types.ts';

// What schemes that choose their own steps share: they divide the world's step so that it ends where it should.
/** A sub-step below this part of the step is no step any more: something is singular or jumps. */
export const SHORTEST = 1e-10;

/** Sub-steps tried in one step before it is given up. */
export const MAX_TRIES = 100_000;

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
    hint: 'A force is singular or jumps there: soften it, keep bodies apart, or take shorter steps.',
  });
}
