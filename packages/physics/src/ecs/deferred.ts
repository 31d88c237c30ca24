// Edits of the world that were made while a step ran.
import { collectThrown } from '../errors/collect-thrown.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Makes the edits in the order in which they were asked for. One that fails does not stop the others. */
export function applyDeferredEdits(world: PhysicsWorld): void {
  const { deferredEdits, leaving } = world.internal;
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
}
