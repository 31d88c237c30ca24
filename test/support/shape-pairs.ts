// Calls the narrow phase for one pair of shapes at a time, for tests.
import { createPhysicsWorld, type Shape } from '@principia/physics';
import { rigidKernels } from '../../packages/physics/src/collision/kernels.ts';
import { writeShape } from '../../packages/physics/src/collision/shapes/store-shape.ts';
import { allocate } from '../../packages/physics/src/memory/arena.ts';
import { realBytes } from '../../packages/physics/src/memory/columns.ts';
import { MANIFOLD_BYTES, SHAPE_BYTES } from '../../packages/physics/src/memory/layouts.gen.ts';

export type Precision = 'f32' | 'f64';
/** Position, m, and angle. */
export type Pose = readonly [x: number, y: number, angle: number];

/** The integers of the record: count and two ids, up to the alignment of the first real. */
const FIRST_REAL = { f32: 12, f64: 16 };

/** Distance up to which points are reported, m. */
export const SPECULATIVE = 0.02;
/** How much further than the nearest point the clipped ones may be. */
export const TOLERANCE = 0.025 * SPECULATIVE;

/** Calls the kernel for pairs in a world of its own. */
export function pairTester(precision: Precision) {
  const world = createPhysicsWorld({ capacity: 1, precision });
  const { arena } = world.internal;
  const [manifold, first, second] = [MANIFOLD_BYTES, SHAPE_BYTES, SHAPE_BYTES].map((bytes) =>
    allocate(arena, bytes[precision], 'a pair of shapes'),
  );
  const { buffer } = world.memory;
  const words = new Uint32Array(buffer, manifold, 3);
  const count = (MANIFOLD_BYTES[precision] - FIRST_REAL[precision]) / realBytes(precision);
  const Reals = precision === 'f32' ? Float32Array : Float64Array;
  const reals = new Reals(buffer, manifold + FIRST_REAL[precision], count);
  return (a: Shape, poseA: Pose, b: Shape, poseB: Pose, speculative = SPECULATIVE) => {
    writeShape(world, first, a);
    writeShape(world, second, b);
    const [ax, ay, angleA] = poseA;
    const [bx, by, angleB] = poseB;
    reals.set([
      ax,
      ay,
      Math.cos(angleA),
      Math.sin(angleA),
      bx,
      by,
      Math.cos(angleB),
      Math.sin(angleB),
      speculative,
      speculative,
    ]);
    rigidKernels(world).collidePair(manifold, first, second);
    const [nx, ny, x0, y0, separation0, x1, y1, separation1] = reals.slice(10);
    const all = [
      { x: x0, y: y0, separation: separation0, id: words[1] },
      { x: x1, y: y1, separation: separation1, id: words[2] },
    ];
    return { nx, ny, points: all.slice(0, words[0]) };
  };
}
