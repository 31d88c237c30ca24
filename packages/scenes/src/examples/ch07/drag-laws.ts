import { createPhysicsWorld, exp, linearDrag, quadraticDrag, rgba, rungeKutta4, spawn } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { velocityArrow } from '../support/arrows.ts';
import { velocityOf } from '../support/read.ts';

export default defineExample({
  id: 'ch07-drag-laws',
  title: 'Two laws of drag',
  chapter: 7,
  tags: ['drag', 'motion'],
  about:
    'Slow things in honey feel drag that grows with the speed, fast things in air drag that grows with its square. The quadratic one brakes hard at first, and then hardly at all: after five seconds its ball is far slower, but it never quite stops: the distance of the other has a limit, its own has none.',
  duration: 30,
  parameters: {
    drag: { label: 'Coefficient k of both', unit: 'kg/s, kg/px', initial: 0.1, min: 0.02, max: 0.5 },
    speed: { label: 'Speed at the start', unit: 'px/s', initial: 20, min: 1, max: 50 },
  },
  presets: [{ label: 'Slow', values: { speed: 1 } }],
  build({ drag, speed }, { integrator = rungeKutta4 }) {
    const world = createPhysicsWorld({ capacity: 4, forces: [linearDrag(), quadraticDrag()], integrator });
    const ball = { velocity: { x: speed }, mass: 1, collider: 8 };
    const appearance = rgba(0.4, 0.7, 1);
    const linear = spawn(world, { ...ball, position: { x: 0, y: 40 }, linearDrag: drag, appearance });
    const square = spawn(world, {
      ...ball,
      position: { x: 0, y: -40 },
      quadraticDrag: drag,
      appearance: rgba(1, 0.6, 0.35),
    });
    return { world, dt: 1 / 60, linear, square };
  },
  picture({ world, linear, square }) {
    return {
      view: { minX: -20, maxX: 230, minY: -75, maxY: 75 },
      trails: [
        { body: linear, length: 2000 },
        { body: square, length: 2000 },
      ],
      arrows: [velocityArrow(world, linear, 1.5), velocityArrow(world, square, 1.5)],
      labels: [
        { at: { x: -5, y: 58 }, text: 'drag −k v' },
        { at: { x: -5, y: -62 }, text: 'drag −k v²' },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Speed',
      'v, px/s',
      {
        label: 'linear',
        value: ({ world, linear }) => velocityOf(world, linear).x,
        exact: (t, { drag, speed }) => speed * exp(-drag * t),
      },
      {
        label: 'quadratic',
        value: ({ world, square }) => velocityOf(world, square).x,
        exact: (t, { drag, speed }) => speed / (1 + drag * speed * t),
      },
    ),
  ],
  checks: ({ at }) => [
    at(
      5,
      'Speed after 5 s of linear drag, v e^(−kt/m)',
      { exact: ({ drag, speed }) => speed * exp(-5 * drag), unit: 'px/s', relative: 1e-4 },
      ({ world, linear }) => velocityOf(world, linear).x,
    ),
    at(
      5,
      'Speed after 5 s of quadratic drag, v/(1 + k v t/m)',
      { exact: ({ drag, speed }) => speed / (1 + 5 * drag * speed), unit: 'px/s', relative: 1e-4 },
      ({ world, square }) => velocityOf(world, square).x,
    ),
  ],
  tryThis: [
    'Choose “Slow”: at 1 px/s both brake alike at first, and then the quadratic drag is the weaker one.',
    'Double k: the ball with linear drag stops after half the distance.',
  ],
});
