import { integrate } from '../dynamics/integrate.ts';
import { turn } from '../dynamics/integrate-rotation.ts';
import { begin, checkFinite } from '../dynamics/validate-state.ts';
import { tellFaults } from '../world/event-handlers.ts';
import type { Preset } from '../world/types.ts';

/** Bodies under forces, without contacts between them: particles, orbits, springs. */
export const standard: Preset = ({ phases }) => {
  phases.begin.push(begin);
  phases.integrate.push(integrate, turn);
  phases.finish.push(checkFinite);
  phases.events.push(tellFaults);
};
