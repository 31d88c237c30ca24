// How shapes get into the pool of a world: what `registerShape` is given, so that only games with shapes contain it.
import { allocate } from '../../memory/arena.ts';
import { writeShapePool } from '../../memory/column-table.ts';
import { realBytes } from '../../memory/columns.ts';
import { SHAPE_BYTES } from '../../memory/layouts.gen.ts';
import { markImmutable } from '../../memory/resource.ts';
import type { PhysicsWorld } from '../../world/types.ts';
import { MAX_VERTICES } from './2d/limits.ts';
import { registerShape, type Shape, type ShapeFunctions, ShapeKind } from './2d/shape.ts';
import { type ShapePool, shapePool, shapesOfBodies } from './shape-pool.ts';

/** Records that a pool has at first; it moves to twice the room when they are used up. */
const FIRST_CAPACITY = 256;

/** The integers `kind`, `count`, `isBox` and `isChained` come first, then the reals. */
const INTEGER_BYTES = 16;

/**
 * Returns the index of a shape in the pool of a world, to which it is added unless an equal one is there. A circle has
 * index 0, because `Collider.radius` says all about it.
 * @throws PhysicsError E_CAPACITY when the world's memory is full
 */
function shapeIndex(world: PhysicsWorld, shape: Shape): number {
  if (shape.kind === 'circle') return 0;
  const pool = shapePool(world);
  forgetSettled(world, pool);
  const { neighbours = [] } = shape;
  const key = `${shape.kind} ${shape.radius} ${shape.vertices.join(' ')} | ${neighbours.join(' ')}`;
  let index = pool.indices.get(key);
  if (index === undefined) {
    index = freeIndex(world, pool);
    writeShape(world, pool.at + index * SHAPE_BYTES[world.precision], shape);
    pool.indices.set(key, index);
    pool.shapes[index] = shape;
    resize(world, pool);
  }
  pool.recent.add(index);
  return index;
}

/** Every shape of an earlier step, or of an earlier call outside a step, is in the column of its body. */
function forgetSettled({ state, tick, internal }: PhysicsWorld, pool: ShapePool): void {
  const isSettled = state === 'idle' || (state === 'stepping' && tick !== pool.tick);
  if (isSettled && internal.spawning === 0) pool.recent.clear();
  pool.tick = tick;
}

function freeIndex(world: PhysicsWorld, pool: ShapePool): number {
  const { shapes, indices } = pool;
  const isFull = () => indices.size + 1 >= pool.capacity;
  if (isFull()) {
    clearUnused(world, pool);
    // Where few records were free, the next search would soon follow.
    if (indices.size >= 0.75 * pool.capacity) growPool(world, pool, isFull());
  }
  const gap = indices.size + 1 < shapes.length ? shapes.indexOf(undefined, 1) : -1;
  return gap > 0 ? gap : shapes.length;
}

/** Clears the records of shapes that no body has, no prefab, and no body that is about to appear. */
function clearUnused(world: PhysicsWorld, pool: ShapePool): void {
  const { memory, precision, internal } = world;
  const used = shapesOfBodies(world);
  for (const index of pool.recent) used.add(index);
  for (const { Collider } of internal.templates.values()) if (Collider !== undefined) used.add(Collider.shape);
  const bytes = SHAPE_BYTES[precision];
  pool.clearings++;
  for (const [key, index] of pool.indices) {
    if (used.has(index)) continue;
    pool.indices.delete(key);
    pool.shapes[index] = undefined;
    new Uint8Array(memory.buffer, pool.at + index * bytes, bytes).fill(0);
  }
  resize(world, pool);
}

/** Brings the number of records up to date, which ends with the last one in use. */
function resize({ memory }: PhysicsWorld, pool: ShapePool): void {
  const { shapes } = pool;
  while (shapes.length > 1 && shapes[shapes.length - 1] === undefined) shapes.pop();
  pool.count = shapes.length;
  writeShapePool(memory, pool.at, pool.count);
}

/** @param isNeeded whether a lack of memory is an error */
function growPool(world: PhysicsWorld, pool: ShapePool, isNeeded: boolean): void {
  const { internal, memory, precision } = world;
  const capacity = Math.max(FIRST_CAPACITY, 2 * pool.capacity);
  let at: number;
  try {
    at = allocate(internal.arena, capacity * SHAPE_BYTES[precision], `${capacity} shapes`);
  } catch (error) {
    if (isNeeded) throw error;
    return;
  }
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

/** A hull is as high as its shape when it is upright, because the circle around a flat box is far higher, and as large as a metre of it. */
function completeHull(body: Record<string, unknown>, { vertices, radius, area }: Shape): void {
  const { hull } = body;
  if (hull === undefined || hull === null) return;
  const heights = vertices.filter((_, i) => i % 2 === 1);
  const halfHeight = (Math.max(...heights) - Math.min(...heights)) / 2 + radius;
  const isList = Array.isArray(hull) || ArrayBuffer.isView(hull);
  const volume = area > 0 ? { volume: area } : {};
  body.hull = { halfHeight, ...volume, ...(typeof hull === 'object' && !isList ? hull : { volume: hull }) };
}

/** What `spawn` does with shapes. */
export const SHAPE_FUNCTIONS: ShapeFunctions = { store: shapeIndex, completeHull };

/** Freezes an object with all that a shape has, and makes it one. */
export function adoptShape(shape: Shape): Shape {
  const { vertices, normals, neighbours, centre } = shape;
  for (const part of [vertices, normals, neighbours, centre]) Object.freeze(part);
  registerShape(shape, SHAPE_FUNCTIONS);
  return markImmutable(Object.freeze(shape));
}
