// The shapes of a world: records in its memory (kernels/collision/shapes/2d/shape.ts), so that snapshots and the state
// hash contain them. Equal shapes share a record. When all records are taken, those that nothing refers to are cleared,
// and later shapes get their indices: the indices follow from the history of the world alone, as on every other machine.
import { namedResource } from '../../memory/resource.ts';
import type { PhysicsWorld } from '../../world/types.ts';
import type { Shape } from './2d/shape.ts';

/** Where the shapes of a world are. */
export interface ShapePool {
  /** Address of record 0, which is zero: index 0 stands for the circle of `Collider.radius`. */
  at: number;
  capacity: number;
  /** Number of records up to the last in use, record 0 included. */
  count: number;
  /** Index of each shape by its bits. */
  readonly indices: Map<string, number>;
  /** The shapes, by index; undefined where a record is free. */
  readonly shapes: (Shape | undefined)[];
  /** Indices handed out since `tick` that may not be in a column yet: bodies appear when the step ends. */
  readonly recent: Set<number>;
  tick: number;
  /** How often records were cleared for other shapes. */
  clearings: number;
}

/** The shape pool of a world, which is empty until the first shape other than a circle. */
export const shapePool = namedResource('shape pool', (): ShapePool => {
  return {
    at: 0,
    capacity: 0,
    count: 1,
    indices: new Map(),
    shapes: [undefined],
    recent: new Set(),
    tick: 0,
    clearings: 0,
  };
});

/** Returns the indices of the shapes that bodies have; 0 is always among them. */
export function shapesOfBodies({ components, lastId }: PhysicsWorld): Set<number> {
  const { shape } = components.Collider;
  const found = new Set([0]);
  for (let id = 1; id <= lastId; id++) if (shape[id] !== 0) found.add(shape[id]);
  return found;
}

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
