import { type ChainOptions, chain } from '../collision/shapes/2d/chain.ts';
import type { PointInput } from '../collision/shapes/2d/shape.ts';
import { removeEntityCompletely } from '../ecs/bitecs/remove-entity.ts';
import { ensureCapacity } from '../ecs/entity-capacity.ts';
import { assertUsable } from '../ecs/guards.ts';
import { checkKeys, checkPoint } from '../errors/validate.ts';
import type { PhysicsWorld } from '../world/types.ts';
import type { BodyInput } from './body-input.ts';
import { spawn } from './spawn.ts';
import { spawnMany } from './spawn-many.ts';

/** How the surface of a chain behaves: the fields of `Collider` except its shape. */
export type ChainSurface = Omit<Exclude<NonNullable<BodyInput['collider']>, number>, 'shape' | 'radius' | 'density'>;

/** Options of `spawnChain`. */
export interface SpawnChainOptions extends ChainOptions {
  /** Where the origin of the points is, m: that of a piece of a large level, whose points are given from there. Default the origin of the world. */
  readonly position?: PointInput;
}

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
  options: SpawnChainOptions = {},
): number[] {
  assertUsable(world);
  checkKeys(options, 'spawnChain', ['closed', 'position']);
  const { position, ...ofChain } = options;
  const origin = position === undefined ? { x: 0, y: 0 } : checkPoint(position, 'spawnChain: position');
  const shapes = chain(points, ofChain);
  ensureCapacity(world, shapes.length);
  const x = shapes.map(({ centre }) => origin.x + centre.x);
  const y = shapes.map(({ centre }) => origin.y + centre.y);
  // During a step bodies are made one by one.
  if (world.state !== 'stepping') {
    return [...spawnMany(world, shapes.length, { position: { x, y }, collider: { ...surface, shape: shapes } })];
  }
  const ids: number[] = [];
  try {
    shapes.forEach((shape, i) => {
      ids.push(spawn(world, { position: { x: x[i], y: y[i] }, collider: { ...surface, shape } }));
    });
  } catch (error) {
    for (const id of ids) removeEntityCompletely(world, id);
    throw error;
  }
  return ids;
}
