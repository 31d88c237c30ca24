// The shapes of a world: records in its memory (kernels/collision/shapes/2d/shape.ts), so that snapshots and the state
// hash contain them. A shape stays until the world ends, and equal shapes share a record.
import { allocate } from '../../memory/arena.ts';
import { writeShapePool } from '../../memory/column-table.ts';
import { realBytes } from '../../memory/columns.ts';
import { SHAPE_BYTES } from '../../memory/layouts.gen.ts';
import { resource } from '../../memory/resource.ts';
import type { PhysicsWorld } from '../../world/types.ts';
import { MAX_VERTICES } from './2d/convex-outline.ts';
import { type Shape, ShapeKind } from './2d/shape.ts';

/** Records that a pool has at first; it moves to twice the room when they are used up. */
const FIRST_CAPACITY = 256;

/** The integers `kind`, `count`, `isBox` and `isChained` come first, then the reals. */
const INTEGER_BYTES = 16;

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
export const shapePool = resource((): ShapePool => {
  return { at: 0, capacity: 0, count: 1, indices: new Map(), shapes: [undefined] };
});

/**
 * Returns the index of a shape in the pool of a world, to which it is added unless an equal one is there. A circle has
 * index 0, because `Collider.radius` says all about it.
 * @throws PhysicsError E_CAPACITY when the world's memory is full
 */
export function shapeIndex(world: PhysicsWorld, shape: Shape): number {
  if (shape.kind === 'circle') return 0;
  const pool = shapePool(world);
  const { neighbours = [] } = shape;
  const key = `${shape.kind} ${shape.radius} ${shape.vertices.join(' ')} | ${neighbours.join(' ')}`;
  const known = pool.indices.get(key);
  if (known !== undefined) return known;
  if (pool.count >= pool.capacity) growPool(world, pool);
  const index = pool.count++;
  writeShape(world, pool.at + index * SHAPE_BYTES[world.precision], shape);
  pool.indices.set(key, index);
  pool.shapes.push(shape);
  writeShapePool(world.memory, pool.at, pool.count);
  return index;
}

function growPool(world: PhysicsWorld, pool: ShapePool): void {
  const { internal, memory, precision } = world;
  const capacity = Math.max(FIRST_CAPACITY, 2 * pool.capacity);
  const at = allocate(internal.arena, capacity * SHAPE_BYTES[precision], `${capacity} shapes`);
  new Uint8Array(memory.buffer).copyWithin(at, pool.at, pool.at + pool.capacity * SHAPE_BYTES[precision]);
  pool.at = at;
  pool.capacity = capacity;
}

/** Writes the record of a shape to an address, a multiple of eight. */
export function writeShape({ memory, precision }: PhysicsWorld, at: number, shape: Shape): void {
  const { kind, vertices, normals, radius, area, inertiaPerMass, extent, minExtent } = shape;
  const { neighbours = [] } = shape;
  const flags = [isBox(vertices) ? 1 : 0, neighbours.length > 0 ? 1 : 0];
  new Uint32Array(memory.buffer, at, 4).set([ShapeKind[kind], vertices.length / 2, ...flags]);
  const length = (SHAPE_BYTES[precision] - INTEGER_BYTES) / realBytes(precision);
  const Reals = precision === 'f32' ? Float32Array : Float64Array;
  const reals = new Reals(memory.buffer, at + INTEGER_BYTES, length);
  const start = length - 4 * MAX_VERTICES;
  reals.set([radius, area, inertiaPerMass, extent, minExtent]);
  reals.set([...vertices, ...neighbours], start);
  reals.set(normals, start + 2 * MAX_VERTICES);
}

function isBox([ax, ay, bx, by, cx, cy, dx, dy, ...more]: readonly number[]): boolean {
  const isRectangle = ax === -cx && ay === -cy && bx === cx && by === ay && dx === ax && dy === cy;
  return isRectangle && more.length === 0;
}

/**
 * Returns the shape of the pool with this index, or undefined for 0 and for an index that the pool does not have.
 * @throws PhysicsError E_DESTROYED
 */
export function shapeAt(world: PhysicsWorld, index: number): Shape | undefined {
  return shapePool(world).shapes[index];
}

/**
 * Returns one more than the highest index that `shapeAt` knows.
 * @throws PhysicsError E_DESTROYED
 */
export function shapeCount(world: PhysicsWorld): number {
  return shapePool(world).count;
}
