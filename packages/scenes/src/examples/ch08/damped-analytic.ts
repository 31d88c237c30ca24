import { createPhysicsWorld, linearDrag, positionFirstEuler, rungeKutta4, spawn, springs } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { displacement } from '../support/damped-oscillator.ts';
import { positionOf } from '../support/read.ts';

const CENTRE = { x: 350, y: 150 };

type Values = ValuesOf<'damping' | 'push' | 'rate'>;

/** Exact position of a ball of 1 kg that starts 250 px to the left and is pushed downwards. */
function exactAt(t: number, { damping, push }: Values) {
  const oscillator = { stiffness: 10, damping };
  return {
    x: CENTRE.x + displacement(oscillator, -250, 0, t),
    y: CENTRE.y + displacement(oscillator, 0, push, t),
  };
}

export default defineExample({
  id: 'ch08-damped-analytic',
  title: 'A damped swing in two directions',
  chapter: 8,
  tags: ['spring', 'oscillation', 'damping', 'integrators'],
  about:
    'The ball swings to and fro, and up and down, and drag takes its energy: it spirals into the middle. The ring moves on the exact solution. The simple scheme is five pixels off at worst, Runge-Kutta 4 less than a ten-thousandth of a pixel.',
  duration: 20,
  ends: true,
  parameters: {
    damping: { label: 'Damping c', unit: 'kg/s', initial: 0.5, min: 0, max: 8 },
    push: { label: 'Velocity downwards', unit: 'px/s', initial: 200, min: 0, max: 600 },
    rate: { label: 'Steps a second', unit: '1/s', initial: 60, min: 20, max: 240, integer: true },
  },
  presets: [{ label: '120 steps a second', values: { rate: 120 } }],
  build(values, { integrator = positionFirstEuler }) {
    const world = createPhysicsWorld({ capacity: 8, forces: [linearDrag(), springs()], integrator });
    const centre = spawn(world, { position: CENTRE });
    const body = { velocity: { y: values.push }, mass: 1, collider: 12, linearDrag: values.damping };
    const ball = spawn(world, { position: { x: CENTRE.x - 250, y: CENTRE.y }, ...body });
    spawn(world, { spring: { a: centre, b: ball, stiffness: 10 } });
    const error = () => {
      const [{ x, y }, exact] = [positionOf(world, ball), exactAt(world.time, values)];
      return Math.max(Math.abs(x - exact.x), Math.abs(y - exact.y));
    };
    return { world, dt: 1 / values.rate, ball, error };
  },
  picture({ world, ball }, values) {
    const exact = (t: number) => exactAt(t, values);
    return {
      yDown: true,
      view: { minX: 60, maxX: 600, minY: 40, maxY: 260 },
      springs: { coils: 16 },
      curves: [
        { points: pointsOf(exact, 0, 20, 800), now: exact, markRadius: 12, label: 'exact', color: COLORS.ground },
      ],
      arrows: [velocityArrow(world, ball, 0.15)],
    };
  },
  plots: (plot) => [
    plot('Along x', 'x, px', {
      label: 'stepped',
      value: ({ world, ball }) => positionOf(world, ball).x - CENTRE.x,
      exact: (t, values) => exactAt(t, values).x - CENTRE.x,
    }),
    plot('Along y', 'y, px', {
      label: 'stepped',
      value: ({ world, ball }) => positionOf(world, ball).y - CENTRE.y,
      exact: (t, values) => exactAt(t, values).y - CENTRE.y,
    }),
  ],
  checks: ({ largest }) => [
    largest(20, 'Largest error', { exact: 5.19, unit: 'px', relative: 0.01 }, ({ error }) => error()),
    largest(
      20,
      'Largest error with steps half as long: half',
      { exact: 5.19 / 2, unit: 'px', relative: 0.02, preset: '120 steps a second' },
      ({ error }) => error(),
    ),
    largest(
      20,
      'Largest error',
      { exact: 0, unit: 'px', absolute: 1e-5, integrator: rungeKutta4, preset: '120 steps a second' },
      ({ error }) => error(),
    ),
  ],
  tryThis: [
    'Change the integrator to Runge-Kutta 4: ball and ring stay together.',
    'Set the damping to zero: the exact path closes to an ellipse, and the stepped one is further and further off.',
  ],
});
