import type { PhysicsWorld } from '@principia/physics';
import { seededUniforms } from './seeded.ts';

/** Gives movable bodies random velocities, uniform along each axis. */
export function shake(world: PhysicsWorld, ids: ArrayLike<number>, speed: number, seed: number): void {
  const { Velocity, Mass } = world.components;
  const uniform = seededUniforms(seed, ids.length);
  for (const axis of world.dimensions === 2 ? (['x', 'y'] as const) : (['x', 'y', 'z'] as const)) {
    const speeds = uniform(-speed, speed);
    for (let i = 0; i < ids.length; i++) if (Mass.value[ids[i]] > 0) Velocity[axis][ids[i]] = speeds[i];
  }
}
