// Entities that lack a component which the step would write to.
//
// Forces move entities with Position, Velocity and Mass. Kernels process columns without checking components, which is
// correct as long as absent components have zero coefficients. Mass without Velocity, or Velocity without Position,
// would make the step write to columns that the entity does not have. Such entities are counted as components are added
// and removed, and while there are any, the step clears these columns; otherwise they cost nothing.
import { bitOf } from '../components/membership.ts';
import { ANGLES, AXES } from '../memory/axes.ts';
import type { PhysicsWorld } from '../world/types.ts';

/** Components of an entity that forces move. */
export const MOVABLE = bitOf('Position') | bitOf('Velocity');

function isImmovable(bits: number): boolean {
  return (bits & bitOf('Mass')) !== 0 && (bits & MOVABLE) !== MOVABLE;
}

function lacksPose(world: PhysicsWorld, bits: number): boolean {
  const drifts = (bits & bitOf('Velocity')) !== 0 && (bits & bitOf('Position')) === 0;
  return drifts || ((bits & bitOf('AngularVelocity')) !== 0 && (bits & angularVelocityBit(world)) === 0);
}

function angularVelocityBit({ dimensions }: PhysicsWorld): number {
  return bitOf(ANGLES[dimensions]);
}

/** Updates the counts when `rows` rows change from one set of components to another. */
export function countPartialEntities(world: PhysicsWorld, from: number, to: number, rows = 1): void {
  const { partialEntities } = world.internal;
  partialEntities.immovable += rows * (Number(isImmovable(to)) - Number(isImmovable(from)));
  partialEntities.withoutPose += rows * (Number(lacksPose(world, to)) - Number(lacksPose(world, from)));
}

/** Clears the force on entities that forces do not move; called after every force evaluation. */
export function clearForcesOfImmovable(world: PhysicsWorld, first: number, last: number): void {
  const { kernels, internal, scratch } = world;
  if (internal.partialEntities.immovable === 0) return;
  for (const axis of AXES[world.dimensions]) {
    kernels.zeroMissing(scratch.at.force[axis], internal.membersAt, MOVABLE, first, last);
  }
}

/** Clears what the step wrote for entities that do not have the component. */
export function clearMissing(world: PhysicsWorld, first: number, last: number): void {
  const { kernels, internal, addresses, dimensions } = world;
  const { immovable, withoutPose } = internal.partialEntities;
  if (immovable === 0 && withoutPose === 0) return;
  const at = internal.membersAt;
  for (const axis of AXES[dimensions]) {
    kernels.zeroMissing(addresses.Position[axis], at, bitOf('Position'), first, last);
    kernels.zeroMissing(addresses.Velocity[axis], at, bitOf('Velocity'), first, last);
  }
  const angles: Record<string, number> = addresses[ANGLES[dimensions]];
  for (const part in angles) kernels.zeroMissing(angles[part], at, angularVelocityBit(world), first, last);
}
