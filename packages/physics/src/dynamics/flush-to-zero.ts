// Flushes tiny values to zero before they are subnormal numbers: a step with these takes some fifty times as long.
import { AXES } from '../memory/axes.ts';
import { isSoftStep } from '../world/is-soft-step.ts';
import type { PhysicsWorld } from '../world/types.ts';

/**
 * Steps between two flushes; with 16 they take 1.4 % of the steps of fireworks. A value becomes smaller by twenty powers of ten
 * within 64 steps only if each of them halves it.
 */
const INTERVAL = 64;

/**
 * Values of a smaller magnitude are flushed, m, m/s, rad and rad/s. The squares of the others are normal numbers, of which the
 * smallest are 1.2e-38 and 2.2e-308.
 */
const TINY = { f32: 1e-18, f64: 1e-150 };

/**
 * Flushes tiny velocities and coordinates to zero, in every 64th step. The coordinates of rigid bodies stay: a sleeping body
 * wakes when they change.
 */
export function flushToZero(world: PhysicsWorld, first: number, last: number): void {
  // On its own, because a function with a closure makes an object in every step.
  if (world.tick % INTERVAL === INTERVAL - 1) flushColumns(world, first, last);
}

function flushColumns(world: PhysicsWorld, first: number, last: number): void {
  const { addresses, dimensions, integrator } = world;
  const turns = world.internal.counts.AngularVelocity > 0;
  const flush = (column: number) => world.kernels.flushToZero(column, TINY[world.precision], first, last);
  for (const axis of AXES[dimensions]) flush(addresses.Velocity[axis]);
  if (turns) for (const axis of dimensions === 2 ? (['z'] as const) : AXES[3]) flush(addresses.AngularVelocity[axis]);
  if (isSoftStep(integrator)) return;
  for (const axis of AXES[dimensions]) flush(addresses.Position[axis]);
  if (turns) flush(addresses.Rotation.angle);
}
