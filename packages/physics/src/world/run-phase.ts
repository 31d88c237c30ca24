import { collectThrown } from '../errors/collect-thrown.ts';
import { reportRejection } from '../errors/report-rejection.ts';
import type { Phase } from './phases.ts';
import { readClock } from './read-clock.ts';
import type { PhysicsWorld, Plan } from './types.ts';

/** Runs the systems of a phase in the order of their list. An exception of one does not stop the others. */
export function runPhase(world: PhysicsWorld, plan: Plan, phase: Phase, dt: number): void {
  const systems = plan.systems[phase];
  const { profile } = world;
  const start = readClock(world);
  for (let s = 0; s < systems.length; s++) {
    const system = systems[s];
    try {
      const isGlobal = typeof system === 'function';
      const result: unknown = isGlobal ? system(world, dt) : system.run(world, world.ranges, dt);
      if (result instanceof Promise) reportRejection(world, `system of the phase "${phase}"`, result);
    } catch (error) {
      collectThrown(world, error);
    }
  }
  // A system may have started or stopped the profile.
  if (profile !== undefined && world.profile === profile) profile.times[phase] += readClock(world) - start;
}
