// The shapes of a world: records in its memory (kernels/collision/shapes/2d/shape.ts), so that snapshots and the state
// hash contain them. A shape stays until the world ends, and equal shapes share a record.
import { namedResource } from '../../memory/resource.ts';
import type { PhysicsWorld } from '../../world/types.ts';
import type { Shape } from './2d/shape.ts';

/** Where the shapes of a world are. */
export interface ShapePool {
  /** Address of record 0, which is zero: index 0 stands for the circle of `Collider.radius`. */
  at: number;
  capacity: number;
  /** Number of records, record 0 included. */
  count: number;
  /** Index of each shape by its bits. */
  readonly indices: Map<string, number>;
  /** The shapes, by index. */
  readonly shapes: (Shape | undefined)[];
}

/** The shape pool of a world, which is empty until the first shape other than a circle. */
export const shapePool = namedResource('shape pool', (): ShapePool => {
  return { at: 0, capacity: 0, count: 1, indices: new Map(), shapes: [undefined] };
});

/**
 * Returns the shape of the pool with this index, or undefined for 0 and for an index that the pool does not have.
 * @throws PhysicsError E_DESTROYED
 */
export function shapeAt(world: PhysicsWorld, index: number): Shape | undefined {
  const { shapes } = shapePool(world);
  return typeof index === 'number' ? shapes[index] : undefined;
}

/**
 * Returns one more than the highest index that `shapeAt` knows.
 * @throws PhysicsError E_DESTROYED
 */
export function shapeCount(world: PhysicsWorld): number {
  return shapePool(world).count;
}
