import type { PhysicsWorld } from '../world';
import { PHASES, type Phase } from './phases';

/** Time spent in each phase since the profile was switched on or reset, in the clock's unit. */
export interface Profile {
  readonly clock: () => number;
  readonly times: Record<Phase, number>;
}

/**
 * Switches profiling on. Physics reads no clock of its own, so the caller hands one in:
 * `startProfile(world, () => performance.now())` gives milliseconds.
 */
export function startProfile(world: PhysicsWorld, clock: () => number): Profile {
  const times = Object.fromEntries(PHASES.map((phase) => [phase, 0])) as Record<Phase, number>;
  const profile = { clock, times };
  world.profile = profile;
  return profile;
}

/** Switches profiling off. */
export function stopProfile(world: PhysicsWorld): void {
  world.profile = undefined;
}

/** Sets all times to zero. */
export function resetProfile(profile: Profile): void {
  for (const phase of PHASES) profile.times[phase] = 0;
}
