import {
  cos,
  createPhysicsWorld,
  explicitEuler,
  heun,
  powerLaw,
  rungeKutta4,
  sin,
  spawn,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf, velocityOf } from '../support/read.ts';

const CENTRE = { x: 400, y: 150 };
const AMPLITUDE = 200;

/** Errors of place and velocity after 1 s with 60 steps, together. */
const ERRORS = [
  { integrator: explicitEuler, exact: [1.67, 0.835, 0.417] },
  { integrator: velocityVerlet, exact: [4.99e-3, 1.25e-3, 3.12e-4] },
  { integrator: heun, exact: [9.26e-3, 2.31e-3, 5.79e-4] },
  { integrator: rungeKutta4, exact: [1.29e-7, 8.04e-9, 5.0e-10] },
];
const STEPS = [
  { rate: 60, about: {} },
  { rate: 120, about: { preset: 'Half the step' } },
  { rate: 240, about: { preset: 'A quarter of the step' } },
];

export default defineExample({
  id: 'ch14-springs',
  title: 'Which scheme keeps to the marks?',
  chapter: 14,
  tags: ['integrators', 'spring', 'accuracy'],
  about:
    'The ball on a spring should swing between the two red marks for ever. With explicit Euler it overshoots them more and more. Choose other integrators, and read how far each is off after one second: Runge-Kutta 4 is ten million times as accurate as explicit Euler, and only takes four times as much work.',
  duration: 60,
  parameters: {
    rate: { label: 'Steps per second', unit: '1/s', initial: 60, min: 4, max: 240, integer: true, scale: 'log' },
  },
  presets: [
    { label: 'Half the step', values: { rate: 120 } },
    { label: 'A quarter of the step', values: { rate: 240 } },
  ],
  build({ rate }: ValuesOf<'rate'>, { integrator = explicitEuler }: BuildOptions) {
    const forces = [powerLaw({ strength: -1, exponent: 1, centre: CENTRE })];
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    const ball = spawn(world, {
      position: { x: CENTRE.x - AMPLITUDE, y: CENTRE.y },
      velocity: {},
      mass: 1,
      collider: 18,
    });
    const exact = (t: number) => ({ x: CENTRE.x - AMPLITUDE * cos(t), y: CENTRE.y });
    const error = () => {
      const { x: v } = velocityOf(world, ball);
      const [place, speed] = [exact(world.time), AMPLITUDE * sin(world.time)];
      return distanceBetween({ x: positionOf(world, ball).x, y: v }, { x: place.x, y: speed });
    };
    return { world, dt: 1 / rate, ball, exact, error };
  },
  picture: ({ world, ball, exact }) => ({
    yDown: true,
    view: { minX: 100, maxX: 700, minY: 0, maxY: 300 },
    lines: [
      ...[CENTRE.x - AMPLITUDE, CENTRE.x + AMPLITUDE].map((x) => ({
        from: { x, y: 100 },
        to: { x, y: 200 },
        color: COLORS.red,
        width: 3,
      })),
      { from: CENTRE, to: () => positionOf(world, ball), coils: 12, color: COLORS.yellow },
    ],
    curves: [{ points: [], now: exact, markRadius: 21, label: 'exact', color: COLORS.grey }],
    trails: [{ body: ball, length: 300 }],
    arrows: [velocityArrow(world, ball, 0.4)],
  }),
  plots: (plot) => [
    plot('Displacement', 'x, px', {
      label: 'stepped',
      value: ({ world, ball }) => positionOf(world, ball).x - CENTRE.x,
      exact: (t) => -AMPLITUDE * cos(t),
    }),
  ],
  checks: [
    ...ERRORS.flatMap(({ integrator, exact }) =>
      STEPS.map(({ rate, about }, i) => ({
        label: `Error after 1 s with ${rate} steps`,
        unit: 'px',
        exact: exact[i],
        tolerance: { relative: 0.006 },
        at: { time: 1 },
        measure: ({ error }: { error(): number }) => error(),
        integrator,
        ...about,
      })),
    ),
  ],
  tryThis: [
    'Halve the step: the error of explicit Euler is halved, too. That is what first order means.',
    'Choose Runge-Kutta 4 and ten steps a second: the ball still keeps to the marks as far as you can see.',
  ],
});
