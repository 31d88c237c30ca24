import { collectThrown } from '../errors/collect-thrown.ts';
import type { PhysicsWorld } from './types.ts';

/** The time by the clock of the profile, 0 without one. The clock is user code: its exceptions are collected, and the step continues. */
export function readClock(world: PhysicsWorld): number {
  try {
    return world.profile?.clock() ?? 0;
  } catch (error) {
    collectThrown(world, error);
    return 0;
  }
}
