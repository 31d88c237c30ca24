import { box, spawn } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { MATERIAL, rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** Edge of a small box, m. */
const EDGE = 0.4;
/** The wall is this many times as wide as high. */
const RATIO = 1.5;

/** A large box that flies into a wall of small ones, without gravity. */
export const smash = defineScene({
  name: 'smash',
  description: 'a large box that flies into a wall of small ones, without gravity',
  precision: 'f32',
  parameters: { count: countOf('small boxes', 9600, 100_000), sleeping },
  build(setup) {
    const { count } = setup.parameters;
    const world = rigidWorld(setup, count + 1, 0);
    const rows = Math.max(1, Math.round(Math.sqrt(count / RATIO)));
    const shift = seededUniforms(setup.seed, 64)(-0.001, 0.001);
    const heavy = { shape: box(8, 8), density: 8, friction: 0.6 };
    spawn(world, { position: { x: -20 }, velocity: { x: 40 }, collider: heavy });
    for (let i = 0; i < count; i++) {
      const position = { x: 30 + EDGE * Math.floor(i / rows), y: EDGE * ((i % rows) - rows / 2) + shift[i % 64] };
      spawn(world, { position, collider: { shape: box(EDGE, EDGE), ...MATERIAL } });
    }
    return runOf(world, 0);
  },
});
