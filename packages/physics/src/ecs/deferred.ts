// Edits of the world that were deferred because a step was running.
import { collectThrown } from '../errors/collect-thrown.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Applies the edits in the order of the calls. A failure of one does not stop the others. */
export function applyDeferredEdits(world: PhysicsWorld): void {
  const { deferredEdits, leaving, pendingValues, departed } = world.internal;
  if (deferredEdits.length === 0) return;
  for (let c = 0; c < deferredEdits.length; c++) {
    try {
      deferredEdits[c]();
    } catch (error) {
      collectThrown(world, error);
    }
  }
  deferredEdits.length = 0;
  leaving.clear();
  pendingValues.clear();
  departed.clear();
}
