import { box, createPhysicsWorld, rgba, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { areaOf, cornersOf, marks, placeOn, star } from '../support/outline.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

export default defineExample({
  id: 'ch13-rigid-body-objects',
  title: 'A ball and a square turn',
  chapter: 13,
  tags: ['rotation', 'shapes'],
  about:
    'Two rigid bodies turn about their centres, in opposite directions and at different rates: the square once in 6.28 s, the ball once in 12.57 s. Their shapes are stored once, in their own axes; where a corner is now follows from the place and the angle of the body.',
  duration: 26,
  parameters: {
    ball: { label: 'Angular velocity of the ball', unit: 'rad/s', initial: -0.5, min: -3, max: 3 },
    square: { label: 'Angular velocity of the square', unit: 'rad/s', initial: 1, min: -3, max: 3 },
  },
  presets: [{ label: 'Like two cogs', values: { ball: -2, square: 1 } }],
  build({ ball, square }, options) {
    const world = createPhysicsWorld({ capacity: 4, ...options });
    const round = spawn(world, {
      position: { x: 180, y: 250 },
      velocity: {},
      mass: 1,
      rotation: Math.PI / 4,
      angularVelocity: ball,
      collider: 50,
      appearance: rgba(1, 0.6, 0.35),
    });
    const block = spawn(world, {
      position: { x: 450, y: 250 },
      velocity: {},
      mass: 1,
      rotation: 0,
      angularVelocity: square,
      collider: { shape: box(200, 200) },
      appearance: rgba(0.25, 0.5, 0.95),
    });
    return { world, dt: 1 / 60, round, block };
  },
  picture({ world, round, block }) {
    return {
      view: { minX: 60, maxX: 640, minY: 80, maxY: 420 },
      dots: [
        ...marks(world, round, star(4, 40), COLORS.white),
        ...[0, 1, 2, 3].map((i) => ({ at: () => cornersOf(world, block)[i], radius: 5 })),
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Angles',
      'angle, rad',
      { label: 'ball', value: ({ world, round }) => world.components.Rotation.angle[round] },
      { label: 'square', value: ({ world, block }) => world.components.Rotation.angle[block] },
    ),
  ],
  checks: ({ at }) => [
    at(
      20,
      'Angle of the ball after 20 s',
      { exact: ({ ball }) => Math.PI / 4 + 20 * ball, unit: 'rad', absolute: 1e-9 },
      ({ world, round }) => world.components.Rotation.angle[round],
    ),
    at(20, 'Area of the square after 20 s', { exact: 40_000, unit: 'px²', relative: 1e-12 }, ({ world, block }) =>
      areaOf(cornersOf(world, block)),
    ),
    at(
      20,
      'Distance of a mark of the ball from its middle after 20 s',
      { exact: 50, unit: 'px', relative: 1e-12 },
      ({ world, round }) => distanceBetween(placeOn(world, round, { x: 50, y: 0 }), positionOf(world, round)),
    ),
  ],
  tryThis: [
    'Give both the same angular velocity: they turn in step.',
    'Choose “Like two cogs”: the smaller one turns twice as fast, and the other way round.',
  ],
});
