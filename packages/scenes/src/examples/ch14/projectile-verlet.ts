import { createPhysicsWorld, positionVerlet, spawn, uniformGravity } from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const START = { x: 50, y: 550 };
const VELOCITY = { x: 30, y: -100 };
type Values = ValuesOf<'gravity' | 'rate'>;
const place = (t: number, gravity: number) => ({
  x: START.x + VELOCITY.x * t,
  y: START.y + VELOCITY.y * t + (gravity / 2) * t * t,
});

export default defineExample({
  id: 'ch14-projectile-verlet',
  title: 'Moving without a velocity',
  chapter: 14,
  tags: ['integrators', 'projectile', 'verlet'],
  about:
    'Position Verlet finds the next place from the last two alone: go on as in the last step, and add a dt². It needs no velocity at all, which suits ropes and cloth. One must only begin well: with a first step that forgets half of a dt², the ball would be off by ½ g dt t for ever after.',
  duration: 20,
  ends: true,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 10, min: 9, max: 30 },
    rate: { label: 'Steps per second', unit: '1/s', initial: 50, min: 1, max: 120, integer: true, scale: 'log' },
  },
  presets: [{ label: 'Two steps a second', values: { rate: 2 } }],
  build({ gravity, rate }: Values, { integrator = positionVerlet }: BuildOptions) {
    const world = createPhysicsWorld({ capacity: 4, forces: [uniformGravity({ y: gravity })], integrator });
    const ball = spawn(world, { position: START, velocity: VELOCITY, mass: 1, collider: 12 });
    const exact = (t: number) => place(t, gravity);
    return {
      world,
      dt: 1 / rate,
      ball,
      exact,
      error: () => distanceBetween(positionOf(world, ball), exact(world.time)),
    };
  },
  picture: ({ world, ball, exact }) => ({
    yDown: true,
    view: { minX: 0, maxX: 800, minY: 0, maxY: 600 },
    curves: [{ points: pointsOf(exact, 0, 20), now: exact, markRadius: 16, label: 'exact', color: COLORS.red }],
    trails: [{ body: ball, length: 1200 }],
    arrows: [velocityArrow(world, ball, 0.6)],
  }),
  plots: (plot) => [
    plot('Height', 'height, px', {
      label: 'stepped',
      value: ({ world, ball }) => START.y - positionOf(world, ball).y,
      exact: (t, { gravity }) => START.y - place(t, gravity).y,
    }),
  ],
  checks: ({ at, largest }) => [
    at(
      10,
      'Height of the apex after 10 s',
      { exact: 500, unit: 'px', absolute: 1e-8 },
      ({ world, ball }) => START.y - positionOf(world, ball).y,
    ),
    at(
      20,
      'Width of the throw after 20 s',
      { exact: 600, unit: 'px', absolute: 1e-8 },
      ({ world, ball }) => positionOf(world, ball).x - START.x,
    ),
    largest(20, 'Largest distance from the parabola', { exact: 0, unit: 'px', absolute: 1e-8 }, ({ error }) => error()),
  ],
  tryThis: [
    'Take two steps a second: the ball jumps, but each of its places is exactly on the parabola.',
    'Choose position-first Euler with two steps a second: it ends 50 px above its ring.',
  ],
});
