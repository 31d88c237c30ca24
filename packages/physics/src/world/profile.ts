import { assertUsable } from '../ecs/guards.ts';
import { checkFunction, checkHas } from '../errors/validate.ts';
import { PHASES, type Phase } from './phases.ts';
import type { PhysicsWorld, Profile } from './types.ts';

/**
 * Switches profiling on. Physics reads no clock of its own, so the caller hands one in:
 * `startProfile(world, () => performance.now())` gives milliseconds.
 * @throws PhysicsError E_TYPE, E_DESTROYED
 */
export function startProfile(world: PhysicsWorld, clock: () => number): Profile {
  assertUsable(world);
  checkFunction(clock, 'startProfile: clock');
  const times = Object.fromEntries(PHASES.map((phase) => [phase, 0])) as Record<Phase, number>;
  const profile = { clock, times };
  world.profile = profile;
  return profile;
}

/** Switches profiling off. @throws PhysicsError E_DESTROYED */
export function stopProfile(world: PhysicsWorld): void {
  assertUsable(world);
  world.profile = undefined;
}

/** Sets all times to zero. @throws PhysicsError E_TYPE for what is no profile */
export function resetProfile(profile: Profile): void {
  checkHas(profile, 'clock', 'resetProfile: profile', 'Give what startProfile returned.');
  for (const phase of PHASES) profile.times[phase] = 0;
}
