import type { GasRun } from '@principia/scenes';
import { type Column, denseColumn } from '../columns';

/** Contacts are looked for out to this multiple of the sum of the radii. */
export const REACH = 1.01;

/** Walls are noted out to this multiple of the radius. */
export const WALL_REACH = 1.1;

/** Parts of a step that impacts are ordered by. */
export const SLICES = 64;

/** The gas as columns by the order of its bodies, and the lists of a step. */
export type Gas = ReturnType<typeof gasOf>;

export function gasOf({ world, dt, side }: GasRun, ids: Uint32Array) {
  const { Position, Velocity, Mass, Collider } = world.components;
  const count = ids.length;
  const column = (from: Column) => denseColumn(world.precision, from, ids);
  const zeros = () => column(Position.x).fill(0);
  const words = (length: number) => new Int32Array(length);
  const capacity = 8 * count;
  let buckets = 1024;
  let bits = 10;
  for (; buckets < 2 * count; buckets *= 2) bits++;
  return {
    count,
    dt: world.precision === 'f32' ? Math.fround(dt) : dt,
    side,
    x: column(Position.x),
    y: column(Position.y),
    vx: column(Velocity.x),
    vy: column(Velocity.y),
    startX: zeros(),
    startY: zeros(),
    ax: zeros(),
    ay: zeros(),
    fromX: zeros(),
    fromY: zeros(),
    /** How far a body may be displaced in a step; f32 in both precisions. */
    most: new Float32Array(count),
    mass: column(Mass.value),
    radius: column(Collider.radius),
    restitution: column(Collider.restitution),
    /** The wall a body is at: 1 left, 2 right, 3 bottom, 4 top, 0 none; how far from it, then how fast it may come. */
    wall: words(count),
    wallGap: zeros(),
    buckets,
    bits,
    bucketOf: words(count),
    starts: words(buckets + 2),
    packed: new (world.precision === 'f32' ? Float32Array : Float64Array)(3 * count),
    packedBody: words(count),
    rawA: words(capacity),
    rawB: words(capacity),
    cursor: words(count),
    a: words(capacity),
    b: words(capacity),
    nx: new Float64Array(capacity),
    ny: new Float64Array(capacity),
    order: words(capacity),
    slice: words(capacity),
    collided: words(capacity),
    ends: words(SLICES + 1),
    contacts: 0,
  };
}
