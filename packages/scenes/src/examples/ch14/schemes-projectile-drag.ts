import {
  createPhysicsWorld,
  exp,
  explicitEuler,
  heun,
  linearDrag,
  rungeKutta4,
  semiImplicitEuler,
  spawn,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const START = { x: 50, y: 400 };
/** Exact place with the drag coefficient 0.1. */
function exactPlace(t: number) {
  const fade = 1 - exp(-0.1 * t);
  return { x: START.x + 600 * fade, y: START.y + 100 * t - 1600 * fade };
}

/** Errors after 10 s with 60 steps a second; two of the schemes are only required to be better than a bound. */
const ERRORS = [
  { integrator: explicitEuler, exact: 0.524, tolerance: { absolute: 5e-4 } },
  { integrator: semiImplicitEuler, exact: 1.28, tolerance: { absolute: 5e-3 } },
  { integrator: velocityVerlet, exact: 0, tolerance: { absolute: 1e-3 } },
  { integrator: heun, exact: 2.9e-4, tolerance: { absolute: 5e-6 } },
  { integrator: rungeKutta4, exact: 0, tolerance: { absolute: 1e-10 } },
];

export default defineExample({
  id: 'ch14-schemes-projectile-drag',
  title: 'Five ways to compute a throw',
  chapter: 14,
  tags: ['integrators', 'projectile', 'accuracy'],
  about:
    'The same throw with drag, and five schemes to choose from. At sixty steps a second none of them looks wrong; the figures tell them apart. Take fewer steps, and you see it: the ring is where the ball should be. Half the step means half the error, a quarter, or a sixteenth: that is the order of the scheme.',
  duration: 10,
  ends: true,
  parameters: {
    rate: { label: 'Steps per second', unit: '1/s', initial: 60, min: 1, max: 120, integer: true, scale: 'log' },
  },
  presets: [
    { label: 'Half the step', values: { rate: 120 } },
    { label: 'One step a second', values: { rate: 1 } },
  ],
  build({ rate }: ValuesOf<'rate'>, { integrator = explicitEuler }: BuildOptions) {
    const forces = [uniformGravity({ y: 10 }), linearDrag()];
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    const ball = spawn(world, { position: START, velocity: { x: 60, y: -60 }, mass: 1, collider: 12, linearDrag: 0.1 });
    const error = () => distanceBetween(positionOf(world, ball), exactPlace(world.time));
    return { world, dt: 1 / rate, ball, error };
  },
  picture: ({ world, ball }) => ({
    yDown: true,
    view: { minX: 0, maxX: 500, minY: 220, maxY: 440 },
    curves: [
      { points: pointsOf(exactPlace, 0, 10), now: exactPlace, markRadius: 15, label: 'exact', color: COLORS.grey },
    ],
    trails: [{ body: ball, length: 1200 }],
    arrows: [velocityArrow(world, ball, 0.6)],
  }),
  plots: (plot) => [
    plot('Distance from the exact place', 'error, px', { label: 'error', value: ({ error }) => error() }),
  ],
  checks: [
    ...ERRORS.map(({ integrator, exact, tolerance }) => ({
      label: 'Error after 10 s',
      unit: 'px',
      exact,
      tolerance,
      at: { time: 10 },
      measure: ({ error }: { error(): number }) => error(),
      integrator,
    })),
    ...[
      { integrator: explicitEuler, label: 'Error with half the step: first order halves it', exact: 0.262 },
      { integrator: semiImplicitEuler, label: 'Error with half the step: first order halves it', exact: 0.64 },
      { integrator: heun, label: 'Error with half the step: second order leaves a quarter', exact: 2.9e-4 / 4 },
    ].map((check) => ({
      ...check,
      unit: 'px',
      tolerance: { relative: 0.02 },
      at: { time: 10 },
      measure: ({ error }: { error(): number }) => error(),
      preset: 'Half the step',
    })),
  ],
  tryThis: [
    'Take one step a second: explicit Euler is some 30 px off at the end, and you see the corners of its path.',
    'Stay at one step a second and choose Runge-Kutta 4: it is off by less than the width of a hair.',
  ],
});
