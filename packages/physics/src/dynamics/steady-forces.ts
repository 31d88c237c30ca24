// Forces that stay the same throughout a step need not be evaluated in each of its sub-steps.
import { columnsRead, readsTime } from '../laws/structure.ts';
import { cachedWithPlan } from '../world/execution-plan.ts';
import type { Force } from '../world/types.ts';

/** Components that change within a step. */
const MOTION: ReadonlySet<string> = new Set(['Position', 'Velocity', 'Rotation', 'Orientation', 'AngularVelocity']);

/** Whether no force of a world depends on the motion of bodies or on time. */
export const areForcesSteady = cachedWithPlan(({ forces }) => forces.every(isSteady));

function isSteady({ law, sources = [], local }: Force): boolean {
  if (law === undefined || !local || readsTime(law)) return false;
  return !columnsRead(law).some((name) => MOTION.has(name)) && !sources.some(({ when }) => when === 'stage');
}
