import { collectThrown } from '../errors/collect-thrown.ts';
import type { Phase } from './phases.ts';
import type { PhysicsWorld, Plan } from './types.ts';

/** Runs every system once, phase by phase. */
export function runPlan(world: PhysicsWorld, { systems }: Plan, dt: number): void {
  const clock = world.profile?.clock;
  for (let s = 0; s < systems.length; s++) {
    const { system, phase } = systems[s];
    const start = clock === undefined ? 0 : clock();
    try {
      if (typeof system === 'function') system(world, dt);
      else system.run(world, world.spans, dt);
    } catch (error) {
      collectThrown(world, error);
    }
    if (clock !== undefined) addTime(world, phase, clock() - start);
  }
}

function addTime(world: PhysicsWorld, phase: Phase, time: number): void {
  if (world.profile !== undefined) world.profile.times[phase] += time;
}
