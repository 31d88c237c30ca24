import { box, type PhysicsWorld, spawn } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { GAP, MATERIAL, rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** Edge of a box, m. */
const EDGE = 1;

/** Height of the triangle of at most `count` boxes, at least 1. */
const heightOf = (count: number) => Math.max(1, Math.floor((Math.sqrt(8 * count + 1) - 1) / 2));

/** Adds a triangle of boxes whose lower left corner is at (x, y). */
export function addPyramid(world: PhysicsWorld, height: number, x: number, y: number, shift: Float64Array): void {
  for (let row = 0, i = 0; row < height; row++) {
    for (let column = 0; column < height - row; column++, i++) {
      const position = { x: x + EDGE * (column + 0.5 * row) + shift[i % shift.length], y: y + EDGE * (row + 0.5) };
      spawn(world, { position, collider: { shape: box(EDGE, EDGE), ...MATERIAL } });
    }
  }
}

/** A pyramid of boxes. */
export const pyramid = defineScene({
  name: 'pyramid',
  description: 'a pyramid of boxes',
  precision: 'f32',
  parameters: { count: countOf('boxes', 5050, 100_000), sleeping },
  build(setup) {
    const { seed, parameters } = setup;
    const height = heightOf(parameters.count);
    const world = rigidWorld(setup, parameters.count + 2);
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(4 * height + 20, 1), friction: 0.6 } });
    addPyramid(world, height, -0.5 * height, 0, seededUniforms(seed, 64)(-GAP, GAP));
    return runOf(world);
  },
});
