import { box, spawn } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { addPyramid } from './pyramid.ts';
import { GAP, rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** Height of each of the small pyramids. */
const SMALL = 10;
const SMALL_COUNT = (SMALL * (SMALL + 1)) / 2;

/** Pyramids of 55 boxes, each on a ground of its own. */
export const manyPyramids = defineScene({
  name: 'many-pyramids',
  description: 'pyramids of 55 boxes, each on a ground of its own',
  precision: 'f32',
  parameters: { count: countOf('boxes', 22_000, 200_000), sleeping },
  build(setup) {
    const { seed, parameters } = setup;
    const pyramids = Math.max(1, Math.floor(parameters.count / SMALL_COUNT));
    const columns = Math.ceil(Math.sqrt(pyramids));
    const world = rigidWorld(setup, pyramids * (SMALL_COUNT + 1));
    const shift = seededUniforms(seed, 64)(-GAP, GAP);
    for (let p = 0; p < pyramids; p++) {
      const x = (p % columns) * (SMALL + 4);
      const y = Math.floor(p / columns) * (SMALL + 4);
      spawn(world, {
        position: { x: x + 0.5 * SMALL, y: y - 0.5 },
        collider: { shape: box(SMALL + 3, 1), friction: 0.6 },
      });
      addPyramid(world, SMALL, x, y, shift);
    }
    return runOf(world);
  },
});
