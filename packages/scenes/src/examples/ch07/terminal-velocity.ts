import { createPhysicsWorld, exp, linearDrag, quadraticDrag, rgba, spawn, uniformGravity } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { forceArrow } from '../support/arrows.ts';
import { tanh } from '../support/hyperbolic.ts';
import { velocityOf } from '../support/read.ts';

const GRAVITY = 10;
const FALL = { x: 0, y: GRAVITY };

export default defineExample({
  id: 'ch07-terminal-velocity',
  title: 'Falling no faster',
  chapter: 7,
  tags: ['drag', 'gravity', 'terminal speed'],
  about:
    'Three balls fall: one without drag, one with linear and one with quadratic drag. Drag grows with the speed until it carries the whole weight; from then on the ball falls evenly, at m g/k or at √(m g/k). Rain would otherwise hit us like shot.',
  duration: 20,
  ends: true,
  parameters: {
    linear: { label: 'Linear coefficient', unit: 'kg/s', initial: 0.5, min: 0.3, max: 2 },
    quadratic: { label: 'Quadratic coefficient', unit: 'kg/px', initial: 0.01, min: 0.005, max: 0.1 },
    mass: { label: 'Mass', unit: 'kg', initial: 1, min: 0.5, max: 4 },
  },
  presets: [{ label: 'Four times as heavy', values: { mass: 4 } }],
  build({ linear, quadratic, mass }, options) {
    const forces = [uniformGravity(FALL), linearDrag(), quadraticDrag()];
    const world = createPhysicsWorld({ capacity: 8, forces, ...options });
    const ball = (x: number, color: number, drag: object) =>
      spawn(world, { position: { x, y: 0 }, velocity: {}, mass, collider: 12, appearance: color, ...drag });
    const free = ball(100, rgba(0.8, 0.85, 1), {});
    const slow = ball(250, rgba(0.4, 0.7, 1), { linearDrag: linear });
    const fast = ball(400, rgba(1, 0.6, 0.35), { quadraticDrag: quadratic });
    return { world, dt: 1 / 60, free, slow, fast };
  },
  picture({ world, free, slow, fast }, { linear, quadratic, mass }) {
    const vy = (id: number) => velocityOf(world, id).y;
    const weights = [free, slow, fast].map((id) =>
      forceArrow(world, id, 'm g', () => ({ x: 0, y: mass * GRAVITY }), 4),
    );
    return {
      yDown: true,
      view: { minX: 0, maxX: 520, minY: -60, maxY: 660 },
      trails: [free, slow, fast].map((body) => ({ body, length: 1500 })),
      arrows: [
        ...weights,
        { ...forceArrow(world, slow, 'drag', () => ({ x: 0, y: -linear * vy(slow) }), 4), color: COLORS.yellow },
        {
          ...forceArrow(world, fast, 'drag', () => ({ x: 0, y: -quadratic * vy(fast) * vy(fast) }), 4),
          color: COLORS.yellow,
        },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Speed',
      'v, px/s',
      {
        label: 'linear',
        value: ({ world, slow }) => velocityOf(world, slow).y,
        exact: (t, { linear, mass }) => ((mass * GRAVITY) / linear) * (1 - exp((-linear * t) / mass)),
      },
      {
        label: 'quadratic',
        value: ({ world, fast }) => velocityOf(world, fast).y,
        exact: (t, { quadratic, mass }) => {
          const limit = Math.sqrt((mass * GRAVITY) / quadratic);
          return limit * tanh((GRAVITY * t) / limit);
        },
      },
    ),
  ],
  checks: ({ at }) => [
    at(
      20,
      'Speed after 20 s of linear drag; the limit is m g/k = 20',
      { exact: 20, unit: 'px/s', relative: 1e-3 },
      ({ world, slow }) => velocityOf(world, slow).y,
    ),
    at(
      20,
      'Speed after 20 s of quadratic drag; the limit is √(m g/k) = 31.62',
      { exact: Math.sqrt(1000), unit: 'px/s', relative: 1e-3 },
      ({ world, fast }) => velocityOf(world, fast).y,
    ),
  ],
  tryThis: [
    'Choose “Four times as heavy”: the linear limit becomes four times as large, the quadratic one twice.',
    'Make the linear coefficient four times as large: the ball falls four times more slowly in the end.',
  ],
});
