import {
  cos,
  createPhysicsWorld,
  positionFirstEuler,
  rungeKutta4,
  sin,
  spawn,
  springs,
  velocityVerlet,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf } from '../support/read.ts';

const CENTRE = { x: 350, y: 150 };
/** The ball starts 250 px to the left and with 50 px/s downwards. */
const exact = (t: number) => ({ x: CENTRE.x - 250 * cos(t), y: CENTRE.y + 50 * sin(t) });

export default defineExample({
  id: 'ch08-free-accuracy',
  title: 'How far off is the stepped oscillation?',
  chapter: 8,
  tags: ['spring', 'oscillation', 'integrators', 'accuracy'],
  about:
    'The ring is where the ball should be: on an ellipse, by sine and cosine. The ball is moved in steps. The simple scheme is two pixels off at worst, and half as much with steps half as long. A scheme of second order is quartered by that.',
  duration: 20,
  ends: true,
  parameters: {
    rate: { label: 'Steps a second', unit: '1/s', initial: 60, min: 5, max: 240, integer: true },
  },
  presets: [
    { label: '120 steps a second', values: { rate: 120 } },
    { label: '10 steps a second', values: { rate: 10 } },
  ],
  build({ rate }, { integrator = positionFirstEuler }) {
    const world = createPhysicsWorld({ capacity: 8, forces: [springs()], integrator });
    const centre = spawn(world, { position: CENTRE });
    const ball = spawn(world, { position: exact(0), velocity: { y: 50 }, mass: 1, collider: 12 });
    spawn(world, { spring: { a: centre, b: ball, stiffness: 1 } });
    const errorX = () => positionOf(world, ball).x - exact(world.time).x;
    const errorY = () => positionOf(world, ball).y - exact(world.time).y;
    return { world, dt: 1 / rate, ball, errorX, errorY };
  },
  picture({ world, ball }) {
    return {
      yDown: true,
      view: { minX: 50, maxX: 650, minY: 40, maxY: 260 },
      springs: { coils: 16 },
      curves: [
        { points: pointsOf(exact, 0, 2 * Math.PI), now: exact, markRadius: 12, label: 'exact', color: COLORS.grey },
      ],
      arrows: [velocityArrow(world, ball, 0.4)],
    };
  },
  plots: (plot) => [
    plot(
      'Error',
      'stepped − exact, px',
      { label: 'x', value: ({ errorX }) => errorX() },
      { label: 'y', value: ({ errorY }) => errorY() },
    ),
    plot('Position', 'x, px', {
      label: 'stepped',
      value: ({ world, ball }) => positionOf(world, ball).x,
      exact: (t) => exact(t).x,
    }),
  ],
  checks: ({ largest }) => [
    largest(20, 'Largest error', { exact: 2.079, unit: 'px', absolute: 5e-4 }, ({ errorX, errorY }) =>
      Math.max(Math.abs(errorX()), Math.abs(errorY())),
    ),
    largest(
      20,
      'Largest error with steps half as long',
      { exact: 1.041, unit: 'px', absolute: 5e-4, preset: '120 steps a second' },
      ({ errorX, errorY }) => Math.max(Math.abs(errorX()), Math.abs(errorY())),
    ),
    largest(
      20,
      'Largest error',
      { exact: 0.0528, unit: 'px', absolute: 5e-5, integrator: velocityVerlet },
      ({ errorX, errorY }) => Math.max(Math.abs(errorX()), Math.abs(errorY())),
    ),
    largest(
      20,
      'Largest error with steps half as long',
      { exact: 0.0132, unit: 'px', absolute: 5e-5, integrator: velocityVerlet, preset: '120 steps a second' },
      ({ errorX, errorY }) => Math.max(Math.abs(errorX()), Math.abs(errorY())),
    ),
    largest(
      20,
      'Largest error',
      { exact: 3e-6, unit: 'px', absolute: 1e-6, integrator: rungeKutta4 },
      ({ errorX, errorY }) => Math.max(Math.abs(errorX()), Math.abs(errorY())),
    ),
  ],
  tryThis: [
    'Choose “10 steps a second”: now you see the ball beside its ring.',
    'With 10 steps a second, change the integrator to Runge-Kutta 4: the ball is back in its ring.',
  ],
});
