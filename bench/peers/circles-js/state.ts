import type { BoxedRun } from '@principia/scenes';
import { type Column, denseColumn } from '../columns.ts';

/** Contacts are looked for out to this multiple of the sum of the radii. */
export const REACH = 1.01;

/** Walls are noted out to this multiple of the radius. */
export const WALL_REACH = 1.1;

/** Parts of a step that impacts are ordered by. */
export const SLICES = 64;

/** The bodies as columns in their order, and the lists of a step. In 2D nothing reads z but as a zero. */
export type Balls = ReturnType<typeof ballsOf>;

export function ballsOf({ world, dt, far, gravity, restitution }: BoxedRun, ids: Uint32Array) {
  const { Position, Velocity, Mass, Collider } = world.components;
  const count = ids.length;
  const column = (from: Column) => denseColumn(world.precision, from, ids);
  const Reals = world.precision === 'f32' ? Float32Array : Float64Array;
  const reals = (length: number) => new Reals(length);
  const words = (length: number) => new Int32Array(length);
  const capacity = 8 * count;
  let buckets = 1024;
  let bits = 10;
  for (; buckets < 2 * count; buckets *= 2) bits++;
  const mass = column(Mass.value);
  const g = world.precision === 'f32' ? Math.fround(-gravity) : -gravity;
  return {
    count,
    flat: world.dimensions === 2,
    dt: world.precision === 'f32' ? Math.fround(dt) : dt,
    far,
    wallRestitution: restitution,
    x: column(Position.x),
    y: column(Position.y),
    z: column(Position.z),
    vx: column(Velocity.x),
    vy: column(Velocity.y),
    vz: column(Velocity.z),
    /** Velocities at the start of the step, then accelerations of the step. */
    startX: reals(count),
    startY: reals(count),
    startZ: reals(count),
    ax: reals(count),
    ay: reals(count),
    az: reals(count),
    fromX: reals(count),
    fromY: reals(count),
    fromZ: reals(count),
    /** How far a body may be displaced in a step; f32 in both precisions. */
    most: new Float32Array(count),
    mass,
    inverseMass: mass.map((m) => 1 / m),
    /** Acceleration of each by gravity, m/s². */
    fall: mass.map(() => g),
    radius: column(Collider.radius),
    restitution: column(Collider.restitution),
    /** Walls met or near: body, axis, side, impulse, part that holds, gap, then the speed it may be closed at. */
    walls: 0,
    wallBody: words(2 * count + 64),
    wallAxis: new Uint8Array(2 * count + 64),
    wallSide: new Int8Array(2 * count + 64),
    wallImpulse: reals(2 * count + 64),
    wallHolding: reals(2 * count + 64),
    wallGap: reals(2 * count + 64),
    /** Whether a body has contacts; 1 + the entry of the wall that holds it most. */
    met: new Uint8Array(count),
    wallOf: words(count),
    buckets,
    bits,
    bucketOf: words(count),
    starts: words(buckets + 2),
    /** x, y, z, radius by the order of buckets, and whose they are. */
    packed: reals(4 * count),
    packedBody: words(count),
    rawA: words(capacity),
    rawB: words(capacity),
    cursor: words(count),
    contacts: 0,
    a: words(capacity),
    b: words(capacity),
    nx: reals(capacity),
    ny: reals(capacity),
    nz: reals(capacity),
    gap: reals(capacity),
    impulse: reals(capacity),
    holding: reals(capacity),
    order: words(capacity),
    slice: words(capacity),
    collided: new Uint8Array(capacity),
    ends: words(SLICES + 1),
    /** The turn in which a body last collided. */
    turn: words(count),
    previous: 0,
    previousA: words(capacity),
    previousB: words(capacity),
    previousHolding: reals(capacity),
  };
}
