// The times of the stages of a step of rigid bodies, where the world is profiled.
import type { SolverStage } from '../world/phases.ts';
import { readClock } from '../world/read-clock.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** When the stage that runs now began, by world: a force may step another one. */
const starts = new WeakMap<PhysicsWorld, number>();

/** Begins the first stage of a step. */
export function startStages(world: PhysicsWorld): void {
  if (world.profile !== undefined) starts.set(world, readClock(world));
}

/** Ends a stage and begins the next. */
export function endStage(world: PhysicsWorld, stage: SolverStage): void {
  const { profile } = world;
  // Somebody may have written an object of his own to `world.profile`.
  if (profile?.stages === undefined) return;
  const now = readClock(world);
  // A force may have started the profile.
  profile.stages[stage] += now - (starts.get(world) ?? now);
  starts.set(world, now);
}
