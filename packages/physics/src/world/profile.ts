import { assertUsable } from '../ecs/guards.ts';
import { checkFunction, checkHas } from '../errors/validate.ts';
import { PHASES, type Phase, type Profile, STEP_PARTS, type StepPart } from './phases.ts';
import type { PhysicsWorld } from './types.ts';

/**
 * Starts profiling. Physics does not read a clock, so the caller passes one: `startProfile(world, () =>
 * performance.now())` gives milliseconds, of each phase and, with rigid bodies, of the parts of their step.
 * @throws PhysicsError E_TYPE, E_DESTROYED
 */
export function startProfile(world: PhysicsWorld, clock: () => number): Profile {
  assertUsable(world);
  checkFunction(clock, 'startProfile: clock');
  const times = Object.fromEntries(PHASES.map((phase) => [phase, 0])) as Record<Phase, number>;
  const parts = Object.fromEntries(STEP_PARTS.map((part) => [part, 0])) as Record<StepPart, number>;
  const profile = { clock, times, parts };
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
  for (const part of STEP_PARTS) profile.parts[part] = 0;
}
