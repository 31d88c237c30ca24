import { spawn, velocityVerlet } from '@principia/physics';
import { addComponent, set } from 'bitecs';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { positionOf, velocityOf } from '../support/read.ts';
import { comeBack, GROUND, RADIUS, STAGE_VIEW, stageWorld } from '../support/stage.ts';

const START = { x: 50, y: 50 };

export default defineExample({
  id: 'ch02-bouncing-ball-object',
  title: 'A ball put together from parts',
  chapter: 2,
  tags: ['bounce', 'components', 'determinism'],
  about:
    'A ball is a collection of components: a position, a velocity, a mass, a shape. One ball got all of them at once; the ring belongs to another, which began as a bare point and was given its mass and its shape afterwards. The computer treats both alike, so they stay together to the last digit.',
  duration: 17,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 360, min: 60, max: 900 },
    speed: { label: 'Speed to the right', unit: 'px/s', initial: 120, min: 0, max: 300 },
  },
  build({ gravity, speed }, { integrator = velocityVerlet }) {
    const world = stageWorld(gravity, { integrator });
    const collider = { radius: RADIUS, restitution: 0.8 };
    const whole = spawn(world, { position: START, velocity: { x: speed }, mass: 1, collider });
    const assembled = spawn(world, { position: START, velocity: { x: speed } });
    addComponent(world, assembled, set(world.components.Mass, { value: 1 }));
    addComponent(world, assembled, set(world.components.Collider, collider));
    comeBack(world, [whole, assembled]);
    const difference = () => {
      const [p, q] = [positionOf(world, whole), positionOf(world, assembled)];
      const [v, w] = [velocityOf(world, whole), velocityOf(world, assembled)];
      return Math.max(...[p.x - q.x, p.y - q.y, v.x - w.x, v.y - w.y].map(Math.abs));
    };
    return { world, dt: 1 / 60, whole, assembled, difference };
  },
  picture: ({ world, whole, assembled }) => ({
    yDown: true,
    view: STAGE_VIEW,
    fills: [GROUND],
    trails: [{ body: whole, length: 250 }],
    curves: [
      {
        points: [],
        now: () => positionOf(world, assembled),
        markRadius: 1.25 * RADIUS,
        label: 'assembled',
        color: COLORS.green,
      },
    ],
  }),
  plots: (plot) => [
    plot(
      'Height of both',
      'height, px',
      { label: 'whole', value: ({ world, whole }) => 480 - positionOf(world, whole).y },
      { label: 'assembled', value: ({ world, assembled }) => 480 - positionOf(world, assembled).y },
    ),
  ],
  checks: ({ largest }) => [
    largest(1000 / 60, 'Largest difference in 1000 steps', { exact: 0, unit: 'px', absolute: 0 }, ({ difference }) =>
      difference(),
    ),
    {
      label: 'Height after the first bounce, 430 e²',
      unit: 'px',
      exact: 275.2,
      tolerance: { relative: 0.005 },
      at: { event: ({ world, assembled }) => velocityOf(world, assembled).y },
      measure: ({ world, assembled }) => 480 - positionOf(world, assembled).y,
    },
  ],
  tryThis: [
    'Choose another gravity or speed: the ring never leaves the ball.',
    'Drag the ball and throw it: now the two differ, because you have touched only one of them.',
  ],
});
