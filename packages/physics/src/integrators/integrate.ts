import { allForcesLocal, evaluateForces } from '../forces/evaluate';
import type { LocalSystem } from '../schedule/phases';

/** Moves the bodies by the world's integrator; tile by tile when every force is local. */
export const integrate: LocalSystem = {
  name: 'integrate',
  usesScratch: true,
  isLocal: (world) => world.integrator.wholeWorld !== true && allForcesLocal(world),
  run(world, spans, dt) {
    world.integrator.advance(world, spans, dt, evaluateForces);
  },
};
