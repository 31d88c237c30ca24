// The times of the parts of a step of rigid bodies, where the world is profiled.
import type { StepPart } from '../world/phases.ts';
import { readClock } from '../world/read-clock.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** When the part that runs now began, by world: a force may step another one. */
const starts = new WeakMap<PhysicsWorld, number>();

/** Begins the first part of a step. */
export function startParts(world: PhysicsWorld): void {
  if (world.profile !== undefined) starts.set(world, readClock(world));
}

/** Ends a part and begins the next. */
export function endPart(world: PhysicsWorld, part: StepPart): void {
  const { profile } = world;
  // Somebody may have written an object of his own to `world.profile`.
  if (profile?.parts === undefined) return;
  const now = readClock(world);
  // A force may have started the profile.
  profile.parts[part] += now - (starts.get(world) ?? now);
  starts.set(world, now);
}
