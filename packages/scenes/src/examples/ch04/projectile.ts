import {
  createPhysicsWorld,
  positionFirstEuler,
  rungeKutta4,
  spawn,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf } from '../support/read.ts';

const START = { x: 100, y: 350 };

export default defineExample({
  id: 'ch04-projectile',
  title: 'A throw, stepped and exact',
  chapter: 4,
  tags: ['gravity', 'projectile', 'integrators'],
  about:
    'A ball is thrown upwards and moved in steps of 1/60 s; the ring moves on the exact parabola. The scheme that moves the ball first and changes its velocity afterwards falls behind by g dt t/2: one pixel and a third after 16 s. Velocity Verlet is exact for a constant force.',
  duration: 16,
  ends: true,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 10, min: 1, max: 30 },
    vx: { label: 'Velocity to the right', unit: 'px/s', initial: 20, min: 0, max: 30 },
    vy: { label: 'Velocity upwards', unit: 'px/s', initial: 80, min: 0, max: 80 },
  },
  build({ gravity, vx, vy }: ValuesOf<'gravity' | 'vx' | 'vy'>, { integrator = positionFirstEuler }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 4, forces: [uniformGravity({ y: gravity })], integrator });
    const ball = spawn(world, { position: START, velocity: { x: vx, y: -vy }, mass: 1, collider: 12 });
    const exact = (t: number) => ({ x: START.x + vx * t, y: START.y - vy * t + (gravity / 2) * t * t });
    return { world, dt: 1 / 60, ball, exact };
  },
  picture({ world, ball, exact }) {
    return {
      yDown: true,
      view: { minX: 60, maxX: 460, minY: 0, maxY: 390 },
      lines: [{ from: { x: 60, y: START.y + 12 }, to: { x: 460, y: START.y + 12 }, color: COLORS.ground }],
      curves: [{ points: pointsOf(exact, 0, 16), now: exact, markRadius: 12, label: 'exact', color: COLORS.grey }],
      arrows: [velocityArrow(world, ball, 0.6)],
    };
  },
  plots: (plot) => [
    plot('Height', 'height, px', {
      label: 'stepped',
      value: ({ world, ball }) => START.y - positionOf(world, ball).y,
      exact: (t, { gravity, vy }) => vy * t - (gravity / 2) * t * t,
    }),
  ],
  checks: ({ at }) => [
    at(
      16,
      'Distance after 16 s',
      { exact: ({ vx }) => 16 * vx, unit: 'px', absolute: 1e-9 },
      ({ world, ball }) => positionOf(world, ball).x - START.x,
    ),
    at(
      16,
      'Too high after 16 s, ½ g dt t',
      { exact: ({ gravity }) => (0.5 * gravity * 16) / 60, unit: 'px', absolute: 1e-4, integrator: positionFirstEuler },
      ({ world, ball, exact }) => exact(world.time).y - positionOf(world, ball).y,
    ),
    at(
      8,
      'Height of the apex',
      { exact: 320, unit: 'px', absolute: 1e-9, integrator: velocityVerlet },
      ({ world, ball }) => START.y - positionOf(world, ball).y,
    ),
    at(
      8,
      'Height of the apex',
      { exact: 320, unit: 'px', absolute: 1e-9, integrator: rungeKutta4 },
      ({ world, ball }) => START.y - positionOf(world, ball).y,
    ),
    ...[velocityVerlet, rungeKutta4].map((integrator) =>
      at(
        16,
        'Back at the height of the start after 16 s: off by',
        { exact: 0, unit: 'px', absolute: 1e-9, integrator },
        ({ world, ball }) => positionOf(world, ball).y - START.y,
      ),
    ),
  ],
  tryThis: [
    'Change the integrator to velocity Verlet: ball and ring stay together.',
    'Double the gravity: the ball lands in half the time, and the error of the first scheme doubles.',
  ],
});
