import { AXES } from '../memory/axes.ts';
import type { PhysicsWorld, Ranges } from '../world/types.ts';

/** Drift: x += v h. */
export function drift(world: PhysicsWorld, ranges: Ranges, h: number): void {
  const { kernels, addresses } = world;
  const { Position, Velocity } = addresses;
  const axes = AXES[world.dimensions];
  for (let a = 0; a < axes.length; a++) {
    const axis = axes[a];
    for (let r = 0; r < ranges.count; r++) {
      kernels.driftAxis(Position[axis], Velocity[axis], h, ranges.bounds[2 * r], ranges.bounds[2 * r + 1]);
    }
  }
}

/** Kick: v += F/m h, with the forces of the last evaluation. */
export function kick(world: PhysicsWorld, ranges: Ranges, h: number): void {
  const { kernels, addresses, scratch } = world;
  const { Velocity, Mass } = addresses;
  const { force } = scratch.at;
  const axes = AXES[world.dimensions];
  for (let a = 0; a < axes.length; a++) {
    const axis = axes[a];
    for (let r = 0; r < ranges.count; r++) {
      const first = ranges.bounds[2 * r];
      kernels.kickAxis(Velocity[axis], force[axis], Mass.value, h, first, ranges.bounds[2 * r + 1]);
    }
  }
}
