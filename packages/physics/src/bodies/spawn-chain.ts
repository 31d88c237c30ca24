import { type ChainOptions, chain } from '../collision/shapes/2d/chain.ts';
import type { PointInput } from '../collision/shapes/2d/shape.ts';
import { removeEntityCompletely } from '../ecs/bitecs/remove-entity.ts';
import { ensureCapacity } from '../ecs/entity-capacity.ts';
import { assertUsable } from '../ecs/guards.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { BodyInput } from './body-input.ts';
import { spawn } from './spawn.ts';

/** How the surface of a chain behaves: the fields of `Collider` except its shape. */
export type ChainSurface = Omit<Exclude<NonNullable<BodyInput['collider']>, number>, 'shape' | 'radius' | 'density'>;

/**
 * Makes the ground of a level, with points from right to left: bodies fall through one from left to right. It is one static body for
 * each segment of a `chain`, along which other bodies slide without catching on its points.
 * @param points m, with what is solid to the left of their direction: a floor leads from right to left
 * @param surface friction, restitution and so on
 * @returns the ids of the bodies, in order along the chain
 * @throws PhysicsError as `chain` and `spawn`: nothing is made
 */
export function spawnChain(
  world: PhysicsWorld,
  points: readonly PointInput[],
  surface: ChainSurface = {},
  options: ChainOptions = {},
): number[] {
  assertUsable(world);
  const shapes = chain(points, options);
  ensureCapacity(world, shapes.length);
  const ids: number[] = [];
  try {
    for (const shape of shapes) ids.push(spawn(world, { position: shape.centre, collider: { ...surface, shape } }));
  } catch (error) {
    for (const id of ids) removeEntityCompletely(world, id);
    throw error;
  }
  return ids;
}
