// A world of rigid bodies as most of their tests use it.
import {
  createPhysicsWorld,
  type PhysicsWorld,
  type PhysicsWorldOptions,
  rigidBodies,
  step,
  uniformGravity,
} from '@principia/physics';

/** The world's gravity, m/s². */
export const G = 9.80665;
/** The step, s. */
export const DT = 1 / 60;
/** Overlap that contacts leave, m. */
export const SLOP = 0.005;

/** Under standard gravity, unless the options say otherwise. */
export function rigidWorld(options: PhysicsWorldOptions = {}): PhysicsWorld {
  return createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity()], capacity: 500, ...options });
}

export function run(world: PhysicsWorld, seconds: number): void {
  for (let i = 0; i < Math.round(seconds / DT); i++) step(world, DT);
}
