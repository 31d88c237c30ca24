import { AXES } from '../store/axes';
import type { Spans } from '../store/spans';
import type { PhysicsWorld } from '../world';

/** Drift: x += v h. */
export function drift(world: PhysicsWorld, spans: Spans, h: number): void {
  const { kernels, addresses } = world;
  const { Position, Velocity } = addresses;
  for (const axis of AXES[world.dimensions]) {
    for (let r = 0; r < spans.count; r++) {
      kernels.driftAxis(Position[axis], Velocity[axis], h, spans.bounds[2 * r], spans.bounds[2 * r + 1]);
    }
  }
}

/** Kick: v += F/m h, with the forces as they were last evaluated. */
export function kick(world: PhysicsWorld, spans: Spans, h: number): void {
  const { kernels, addresses, scratch } = world;
  const { Velocity, Mass } = addresses;
  const { force } = scratch.at;
  for (const axis of AXES[world.dimensions]) {
    for (let r = 0; r < spans.count; r++) {
      const first = spans.bounds[2 * r];
      kernels.kickAxis(Velocity[axis], force[axis], Mass.value, h, first, spans.bounds[2 * r + 1]);
    }
  }
}
