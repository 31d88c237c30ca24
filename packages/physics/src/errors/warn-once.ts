import type { PhysicsWorld, Warning } from '../world/types.ts';

/**
 * Gives a warning to `world.onWarning`, unless this world has had one of the same key.
 * @param key by default the message: give another where the message has numbers that change
 */
export function warnOnce(world: PhysicsWorld, warning: Warning, key = warning.message): void {
  const { warned } = world.internal;
  if (warned.has(key)) return;
  warned.add(key);
  world.onWarning(warning);
}
