import type { PhysicsWorld } from '../world/types.ts';

/**
 * Maximum number of exceptions kept per step. A force that throws does so for every chunk, which is often for a million
 * bodies.
 */
const MAX_THROWN = 32;

/** Collects an exception of user code until the end of the step. */
export function collectThrown({ internal }: PhysicsWorld, error: unknown): void {
  internal.thrownCount++;
  if (internal.thrown.length < MAX_THROWN) internal.thrown.push(error);
}
