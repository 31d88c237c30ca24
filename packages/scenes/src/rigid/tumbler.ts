import { box, createJoint, type PhysicsWorld, revolute, spawn, spawnCompound } from '@principia/physics';
import { countOf, defineScene } from '../scene.ts';
import { seededUniforms } from '../seeded.ts';
import { GAP, MATERIAL, rigidWorld, runOf, sleeping } from './rigid-scene.ts';

/** Angular speed of the drum, rad/s, and thickness of its walls, m: those of Box2D's tumbler. */
const DRUM_SPEED = 0.4363323129985824;
const WALL = 0.5;

/** Boxes that tumble in a square drum turned by a motor. */
export const tumbler = defineScene({
  name: 'tumbler',
  description: 'boxes that tumble in a square drum turned by a motor',
  precision: 'f32',
  parameters: { count: countOf('boxes', 2025, 20_000), sleeping },
  build(setup) {
    const { seed, parameters } = setup;
    const { count } = parameters;
    const edge = Math.ceil(Math.sqrt(count));
    const size = 0.25;
    const half = Math.max(2, 0.8 * size * edge);
    const world = rigidWorld(setup, count + 20);
    addDrum(world, half);
    const shift = seededUniforms(seed, 64)(-GAP, GAP);
    for (let i = 0; i < count; i++) {
      const [x, y] = [i % edge, Math.floor(i / edge)].map((place) => (place - 0.5 * (edge - 1)) * size * 1.05);
      const collider = { shape: box(size, size), ...MATERIAL };
      spawn(world, { position: { x: x + 0.1 * shift[i % 64], y }, collider });
    }
    return runOf(world);
  },
});

/** Four walls, one compound body that a motor turns. */
function addDrum(world: PhysicsWorld, half: number): void {
  const pivot = spawn(world, { position: {}, rotation: 0, collider: { radius: 0.1, mask: 0 } });
  const across = box(2 * half + 2 * WALL, WALL);
  const along = box(WALL, 2 * half + 2 * WALL);
  const place = half + 0.5 * WALL;
  const material = { density: 50, friction: 0.6 };
  const parts = [
    { shape: across, y: place, ...material },
    { shape: across, y: -place, ...material },
    { shape: along, x: place, ...material },
    { shape: along, x: -place, ...material },
  ];
  const { body } = spawnCompound(world, { position: {}, velocity: {}, angularVelocity: 0, parts });
  createJoint(world, revolute({ a: pivot, b: body, anchor: {}, motor: { speed: DRUM_SPEED, max: 1e8 } }));
}
