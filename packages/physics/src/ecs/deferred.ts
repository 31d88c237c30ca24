// Edits of the world that were made while a step ran.
import { collectThrown } from '../errors/collect-thrown.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Makes the edits in the order in which they were asked for. One that fails does not stop the others. */
export function applyDeferredEdits(world: PhysicsWorld): void {
  const { commands, leaving } = world.internal;
  if (commands.length === 0) return;
  for (let c = 0; c < commands.length; c++) {
    try {
      commands[c]();
    } catch (error) {
      collectThrown(world, error);
    }
  }
  commands.length = 0;
  leaving.clear();
}
