import { boxWalls, createPhysicsWorld, rgba, spawn, uniformGravity } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const RADIUS = 20;
/** The three walls are at x, y and z = -100. */
const WALL = -100;
const REST = WALL + RADIUS;

export default defineExample({
  id: 'ch15-bouncing-ball-3d',
  title: 'A ball bounces in a corner',
  chapter: 15,
  tags: ['three dimensions', 'collisions', 'gravity'],
  about:
    'A ball falls into a corner of three walls. Each wall turns the velocity at right angles to it and leaves the rest alone, so the ball hops ever lower, by the square of the restitution, while it crosses the floor.',
  dimensions: 3,
  duration: 12,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 20, min: 1, max: 60 },
    restitution: { label: 'Restitution', unit: '', initial: 0.9, min: 0, max: 1 },
  },
  build({ gravity, restitution }, options) {
    const world = createPhysicsWorld({
      dimensions: 3,
      capacity: 4,
      forces: [uniformGravity({ y: -gravity })],
      walls: [boxWalls({ min: { x: WALL, y: WALL, z: WALL } })],
      ...options,
    });
    const ball = spawn(world, {
      position: { x: 100 },
      velocity: { x: -20, z: -20 },
      mass: 1,
      collider: { radius: RADIUS, restitution },
      appearance: rgba(1, 0.55, 0.3),
    });
    return { world, dt: 1 / 60, ball };
  },
  picture({ world, ball }) {
    const at = () => positionOf(world, ball);
    const floor = { minX: WALL, maxX: 140, minY: WALL, maxY: WALL, minZ: WALL, maxZ: 60 };
    return {
      view: { minX: WALL, maxX: 140, minY: WALL, maxY: 40, minZ: WALL, maxZ: 60 },
      fills: [
        { shape: floor, color: 0x39457a },
        { shape: { ...floor, maxY: 40, maxZ: WALL }, color: 0x2f6f6a },
        { shape: { ...floor, maxX: WALL, maxY: 40 }, color: 0x6a3f6f },
      ],
      trails: [{ body: ball, length: 600 }],
      arrows: [{ label: 'v', from: at, vector: () => velocityOf(world, ball), color: COLORS.green }],
      camera: { eye: { x: 160, y: 60, z: 400 }, target: { x: 0, y: 0, z: 0 } },
    };
  },
  plots: [
    {
      title: 'Height above rest',
      y: { label: 'height, px' },
      series: [{ label: 'height', value: ({ world, ball }) => positionOf(world, ball).y - REST }],
    },
  ],
  checks: [
    {
      label: 'Height of the first apex, 80 e²',
      unit: 'px',
      exact: ({ restitution }) => 80 * restitution * restitution,
      tolerance: { relative: 2e-3 },
      at: { event: ({ world, ball }) => (world.time > 3 ? -velocityOf(world, ball).y : -1) },
      measure: ({ world, ball }) => positionOf(world, ball).y - REST,
    },
    {
      label: 'Time of the bounce from the wall at the back',
      unit: 's',
      exact: 4,
      tolerance: { absolute: 1 / 60 },
      at: { event: ({ world, ball }) => velocityOf(world, ball).z },
      measure: ({ world }) => world.time,
    },
    {
      label: 'Time of the bounce from the wall at the left',
      unit: 's',
      exact: 9,
      tolerance: { absolute: 1 / 60 },
      at: { event: ({ world, ball }) => velocityOf(world, ball).x },
      measure: ({ world }) => world.time,
    },
  ],
  tryThis: ['Set the restitution to one: the ball never stops.', 'Turn the view by dragging beside the ball.'],
});
