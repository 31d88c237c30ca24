import { assertUsable } from '../ecs/guards.ts';
import { checkFunction, checkHas } from '../errors/validate.ts';
import { PHASES, type Phase, type Profile, SOLVER_STAGES, type SolverStage } from './phases.ts';
import type { PhysicsWorld } from './types.ts';

/**
 * Starts profiling. Physics does not read a clock, so the caller passes one: `startProfile(world, () =>
 * performance.now())` gives milliseconds, of each phase and, with rigid bodies, of the stages of their step.
 * @throws PhysicsError E_TYPE, E_DESTROYED
 */
export function startProfile(world: PhysicsWorld, clock: () => number): Profile {
  assertUsable(world);
  checkFunction(clock, 'startProfile: clock');
  const times = Object.fromEntries(PHASES.map((phase) => [phase, 0])) as Record<Phase, number>;
  const stages = Object.fromEntries(SOLVER_STAGES.map((stage) => [stage, 0])) as Record<SolverStage, number>;
  const profile = { clock, times, stages };
  world.profile = profile;
  return profile;
}

/** Stops profiling. @throws PhysicsError E_DESTROYED */
export function stopProfile(world: PhysicsWorld): void {
  assertUsable(world);
  world.profile = undefined;
}

/** Sets all times to zero. @throws PhysicsError E_TYPE if the argument is not a profile */
export function resetProfile(profile: Profile): void {
  checkHas(profile, 'clock', 'resetProfile: profile', 'Pass the profile that startProfile returned.');
  for (const phase of PHASES) profile.times[phase] = 0;
  for (const stage of SOLVER_STAGES) profile.stages[stage] = 0;
}
