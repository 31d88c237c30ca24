// Edits of the world that were deferred because a step was running.
import { collectThrown } from '../errors/collect-thrown.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Applies the edits in the order of the calls. A failure of one does not stop the others. */
export function applyDeferredEdits(world: PhysicsWorld): void {
  const { deferred, leaving, pending, departed } = world.internal.edits;
  if (deferred.length === 0) return;
  for (let c = 0; c < deferred.length; c++) {
    try {
      deferred[c]();
    } catch (error) {
      collectThrown(world, error);
    }
  }
  deferred.length = 0;
  leaving.clear();
  pending.clear();
  departed.clear();
}
