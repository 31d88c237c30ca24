import { boxWalls, createPhysicsWorld, spawn, uniformGravity, velocityVerlet } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf } from '../support/read.ts';

const RADIUS = 0.1;

export default defineExample({
  id: 'ch14-timestep-tips',
  title: 'How long may a step be?',
  chapter: 14,
  tags: ['integrators', 'bounce', 'accuracy'],
  about:
    'The floor is hit in the middle of a step, at a time that no step knows. If a program only notices at the end that the ball is too deep, it bounces wrong by an error that grows with the step. This one computes the true moment of the impact within the step. So even steps of a tenth of a second leave the bounce right; only the places where you look are few.',
  duration: 4,
  parameters: {
    rate: { label: 'Steps per second', unit: '1/s', initial: 50, min: 10, max: 240, integer: true, scale: 'log' },
    height: { label: 'Height of the drop', unit: 'm', initial: 1, min: 0.5, max: 1.2 },
  },
  presets: [{ label: 'Half the step', values: { rate: 100 } }],
  build({ rate, height }: ValuesOf<'rate' | 'height'>, { integrator = velocityVerlet }: BuildOptions) {
    const walls = [boxWalls({ min: { y: 0 } })];
    const world = createPhysicsWorld({ capacity: 4, forces: [uniformGravity({ y: -10 })], walls, integrator });
    const collider = { radius: RADIUS, restitution: 0.8 };
    const ball = spawn(world, { position: { y: height + RADIUS }, velocity: {}, mass: 1, collider });
    // Height of the apex as seen at the steps: only after the bounce.
    const risen = () => (world.time > 0.5 && world.time < 1.2 ? positionOf(world, ball).y - RADIUS : 0);
    return { world, dt: 1 / rate, ball, risen };
  },
  picture: ({ world, ball }, { height }) => ({
    view: { minX: -1.2, maxX: 1.2, minY: -0.15, maxY: 1.45 },
    fills: [{ shape: { minX: -50, maxX: 50, minY: -50, maxY: 0 }, color: COLORS.ground }],
    lines: [height, 0.64 * height].map((h) => ({
      from: { x: -0.6, y: h + RADIUS },
      to: { x: 0.6, y: h + RADIUS },
      color: COLORS.grey,
      width: 1,
    })),
    labels: [{ at: { x: 0.62, y: 0.64 * height + RADIUS - 0.03 }, text: 'e² of the height', color: COLORS.grey }],
    trails: [{ body: ball, length: 100 }],
    arrows: [velocityArrow(world, ball, 0.15)],
  }),
  plots: (plot) => [
    plot('Height', 'height, m', { label: 'height', value: ({ world, ball }) => positionOf(world, ball).y - RADIUS }),
  ],
  checks: ({ largest }) => [
    // The highest step is at most half a step from the apex, where the ball is ½ g (dt/2)² lower.
    largest(
      1.2,
      'Apex after the bounce, within ⅛ g dt²',
      { exact: 0.64, unit: 'm', absolute: (10 / 8) * 0.02 * 0.02 },
      ({ risen }) => risen(),
    ),
    largest(
      1.2,
      'The same with half the step: a quarter of the bound',
      { exact: 0.64, unit: 'm', absolute: (10 / 8) * 0.01 * 0.01, preset: 'Half the step' },
      ({ risen }) => risen(),
    ),
  ],
  tryThis: [
    'Take ten steps a second: the ball jumps in large strides, and still comes back to the right height.',
    'Watch the plot with few steps: its corners are the only moments at which the computer looked.',
  ],
});
