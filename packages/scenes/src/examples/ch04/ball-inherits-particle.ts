import { createPhysicsWorld, rgba, spawn, uniformGravity } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { positionOf } from '../support/read.ts';

export default defineExample({
  id: 'ch04-ball-inherits-particle',
  title: 'A ball is a particle and more',
  chapter: 4,
  tags: ['components', 'gravity'],
  about:
    'In most languages one would say that a ball inherits from a particle. Here things are composed: give a particle the component that holds a radius, and it is a ball; take it away, and it is a point again. What moves it does not look at the radius, so both fly together.',
  duration: 3,
  parameters: {
    radius: { label: 'Radius of the ball', unit: 'px', initial: 20, min: 5, max: 60 },
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 60, min: 0, max: 200 },
  },
  build({ radius, gravity }: ValuesOf<'radius' | 'gravity'>, options) {
    const world = createPhysicsWorld({ capacity: 4, forces: [uniformGravity({ y: gravity })], ...options });
    const add = (y: number, more: object) =>
      spawn(world, { position: { x: 60, y }, velocity: { x: 180, y: -90 }, mass: 1, ...more });
    const ball = add(180, { collider: radius, appearance: rgba(0.43, 0.72, 1) });
    const particle = add(380, { appearance: { size: 6, color: rgba(1, 0.7, 0.3) } });
    const gap = () => positionOf(world, particle).y - positionOf(world, ball).y;
    return { world, dt: 1 / 60, ball, particle, gap };
  },
  picture: ({ ball, particle }) => ({
    yDown: true,
    view: { minX: 0, maxX: 700, minY: 40, maxY: 540 },
    trails: [{ body: ball }, { body: particle }],
  }),
  plots: (plot) => [
    plot('Distance of the two', 'distance, px', { label: 'distance', value: ({ gap }) => gap(), exact: () => 200 }),
  ],
  checks: ({ at }) => [
    at(
      3,
      'How much farther the ball got than the particle in 3 s, x',
      { exact: 0, unit: 'px', absolute: 0 },
      ({ world, ball, particle }) => positionOf(world, ball).x - positionOf(world, particle).x,
    ),
    // Sums of 180 steps at different heights are rounded differently.
    at(3, 'Their distance after 3 s', { exact: 200, unit: 'px', absolute: 1e-10 }, ({ gap }) => gap()),
  ],
  tryThis: ['Make the ball as large as you like: without air and walls its size is for the eye only.'],
});
