import { box, spawn } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** Radius of a disc, distance at which they start, and largest speed along an axis. */
const RADIUS = 0.4;
const DISTANCE = 1;
const SPEED = 5;

/** Discs that bounce off each other and off the walls of a room, without friction and gravity. */
export const elasticDiscs = defineScene({
  name: 'elastic-discs',
  description: 'discs that bounce off each other and off the walls of a room, without friction and gravity',
  precision: 'f32',
  parameters: { count: countOf('discs', 4_000, 100_000), sleeping },
  build(setup) {
    const { count } = setup.parameters;
    const columns = Math.ceil(Math.sqrt(count));
    const half = 0.5 * DISTANCE * columns + 0.5;
    const material = { friction: 0, restitution: 1 };
    const world = rigidWorld(setup, count + 4, 0);
    for (const side of [-1, 1]) {
      const away = side * (half + 0.5);
      spawn(world, { position: { x: away }, collider: { shape: box(1, 2 * half + 2), ...material } });
      spawn(world, { position: { y: away }, collider: { shape: box(2 * half + 2, 1), ...material } });
    }
    const uniforms = seededUniforms(setup.seed, 2 * count);
    const speeds = uniforms(-SPEED, SPEED);
    for (let i = 0; i < count; i++) {
      const x = DISTANCE * ((i % columns) - 0.5 * (columns - 1));
      const y = DISTANCE * (Math.floor(i / columns) - 0.5 * (columns - 1));
      const velocity = { x: speeds[2 * i], y: speeds[2 * i + 1] };
      spawn(world, { position: { x, y }, velocity, collider: { radius: RADIUS, density: 1, ...material } });
    }
    return { ...runOf(world, 0), losesEnergy: 'impacts slower than 1 m/s do not bounce' };
  },
});
