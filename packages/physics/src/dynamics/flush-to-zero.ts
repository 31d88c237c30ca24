// Numbers too small to matter become zero, because processors take a hundred times as long for the smallest ones.
import { AXES } from '../memory/axes.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';

/**
 * Steps from one time to the next: every 16th takes 1.4 % of a step of sparks. A number becomes smaller by twenty powers of ten
 * meanwhile only if every step halves it.
 */
const INTERVAL = 64;

/**
 * What is nearer to zero than this is set to zero, m, m/s, rad and rad/s. Squares of what remains are normal numbers: the smallest
 * of these are 1.2e-38 and 2.2e-308.
 */
const TINY = { f32: 1e-18, f64: 1e-150 };

/**
 * Sets velocities and coordinates that are next to nothing to zero, in every 64th step. The coordinates of rigid bodies stay: one
 * that sleeps wakes when they change.
 */
export function flushToZero(world: PhysicsWorld, first: number, last: number): void {
  const { addresses, dimensions, tick, integrator } = world;
  if (tick % INTERVAL !== INTERVAL - 1) return;
  const turns = world.internal.counts.AngularVelocity > 0;
  const flush = (column: number) => world.kernels.flushToZero(column, TINY[world.precision], first, last);
  for (const axis of AXES[dimensions]) flush(addresses.Velocity[axis]);
  if (turns) for (const axis of dimensions === 2 ? (['z'] as const) : AXES[3]) flush(addresses.AngularVelocity[axis]);
  if (isSoftStep(integrator)) return;
  for (const axis of AXES[dimensions]) flush(addresses.Position[axis]);
  if (turns) flush(addresses.Rotation.angle);
}
