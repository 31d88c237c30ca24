import { box, spawn } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { GAP, MATERIAL, rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** Radius of a disc, and distance at which they start, m. */
const RADIUS = 0.25;
const DISTANCE = 0.55;

/** Discs that fall into a trough and come to rest. */
export const discs = defineScene({
  name: 'discs',
  description: 'discs that fall into a trough and come to rest',
  precision: 'f32',
  parameters: { count: countOf('discs', 10_000, 100_000), sleeping },
  build(setup) {
    const { count } = setup.parameters;
    const columns = Math.ceil(Math.sqrt(2 * count));
    const half = 0.5 * DISTANCE * columns + 1;
    const height = 2 * half;
    const world = rigidWorld(setup, count + 3);
    const wall = (x: number, y: number, width: number, tall: number) =>
      spawn(world, { position: { x, y }, collider: { shape: box(width, tall), friction: 0.6 } });
    wall(0, -0.5, 2 * half + 2, 1);
    wall(-half - 0.5, 0.5 * height, 1, height);
    wall(half + 0.5, 0.5 * height, 1, height);
    const shift = seededUniforms(setup.seed, 512)(-GAP, GAP);
    for (let i = 0; i < count; i++) {
      const x = DISTANCE * ((i % columns) - 0.5 * (columns - 1)) + shift[i % 512];
      const position = { x, y: DISTANCE * (Math.floor(i / columns) + 1) };
      spawn(world, { position, rotation: 0, collider: { radius: RADIUS, ...MATERIAL } });
    }
    return runOf(world);
  },
});
