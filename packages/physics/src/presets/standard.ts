import { integrate } from '../dynamics/integrate.ts';
import { integrateRotation } from '../dynamics/integrate-rotation.ts';
import { beginStep, validateState } from '../dynamics/validate-state.ts';
import { assertPresetWorld } from '../ecs/guards.ts';
import { dispatchFaultEvents } from '../world/event-handlers.ts';
import type { Preset } from '../world/types.ts';

/** Bodies under forces without contacts between them: particles, orbits, springs. */
export const standard: Preset = (world) => {
  assertPresetWorld(world, 'standard');
  const { phases } = world;
  phases.begin.push(beginStep);
  phases.integrate.push(integrate, integrateRotation);
  phases.finish.push(validateState);
  phases.events.push(dispatchFaultEvents);
};
