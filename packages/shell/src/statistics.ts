import { bodies } from '@principia/physics';
import type { GameDefinition, Simulation } from './game.ts';
import type { Settings } from './settings.ts';

/** The statistics of one update. */
export interface Statistics {
  /** Milliseconds per frame, per step, and per submission of the world to the renderer. */
  frame: number;
  step: number;
  draw: number;
  bodies: number;
  /** Contacts between bodies; undefined where the world does not count them. */
  contacts: number | undefined;
  /** Simulated seconds. */
  time: number;
}

export const noStatistics = (): Statistics => ({
  frame: 0,
  step: 0,
  draw: 0,
  bodies: 0,
  contacts: undefined,
  time: 0,
});

/** Writes what is counted in a world into `out`, which is returned. */
export function countInto<S extends Settings, Sim extends Simulation>(
  out: Statistics,
  game: GameDefinition<S, Sim>,
  sim: Sim,
): Statistics {
  out.bodies = game.bodies?.(sim) ?? bodies(sim.world).count;
  out.contacts = game.contacts?.(sim);
  out.time = sim.world.time;
  return out;
}
