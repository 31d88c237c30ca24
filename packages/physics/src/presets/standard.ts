import { integrate } from '../dynamics/integrate';
import { tellFaults } from '../events/handlers';
import { turn } from '../integrators/turn';
import { begin, checkFinite } from '../schedule/quarantine';
import type { Preset } from './preset';

/** Bodies under forces, without contacts between them: particles, orbits, springs. */
export const standard: Preset = ({ phases }) => {
  phases.begin.push(begin);
  phases.integrate.push(integrate, turn);
  phases.finish.push(checkFinite);
  phases.events.push(tellFaults);
};
