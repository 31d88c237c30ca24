import type { PhysicsWorld, Warning } from '../world/types.ts';

/** Gives a warning to `world.onWarning`, unless this world has had the same one. */
export function warnOnce(world: PhysicsWorld, warning: Warning): void {
  const { warned } = world.internal;
  if (warned.has(warning.message)) return;
  warned.add(warning.message);
  world.onWarning(warning);
}
