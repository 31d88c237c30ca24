// How shapes get into the pool of a world: what `registerShape` is given, so that only games with shapes contain it.
import { allocate } from '../../memory/arena.ts';
import { writeShapePool } from '../../memory/column-table.ts';
import { realBytes } from '../../memory/columns.ts';
import { SHAPE_BYTES } from '../../memory/layouts.gen.ts';
import type { PhysicsWorld } from '../../world/types.ts';
import { MAX_VERTICES } from './2d/limits.ts';
import { type Shape, ShapeKind } from './2d/shape.ts';
import { type ShapePool, shapePool } from './shape-pool.ts';

/** Records that a pool has at first; it moves to twice the room when they are used up. */
const FIRST_CAPACITY = 256;

/** The integers `kind`, `count`, `isBox` and `isChained` come first, then the reals. */
const INTEGER_BYTES = 16;

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
