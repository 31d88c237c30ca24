import type { PhysicsWorld } from '../world/types.ts';

/** Exceptions kept of one step. A force that throws does so for every tile, which for a million bodies is often. */
const MAX_THROWN = 32;

/** Keeps what users' code threw, for the end of the step. */
export function collectThrown({ internal }: PhysicsWorld, error: unknown): void {
  internal.thrownCount++;
  if (internal.thrown.length < MAX_THROWN) internal.thrown.push(error);
}
