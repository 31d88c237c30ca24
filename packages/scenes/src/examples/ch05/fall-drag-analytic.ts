import {
  createPhysicsWorld,
  exp,
  linearDrag,
  positionFirstEuler,
  spawn,
  uniformGravity,
  velocityVerlet,
} from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { velocityArrow } from '../support/arrows.ts';
import { positionOf, velocityOf } from '../support/read.ts';

type Values = ValuesOf<'gravity' | 'drag'>;
const START = 20;
const exactSpeed = (t: number, { gravity, drag }: Values) => (gravity / drag) * (1 - exp(-drag * t));
const exactWay = (t: number, { gravity, drag }: Values) => (gravity / drag) * (t - (1 - exp(-drag * t)) / drag);

export default defineExample({
  id: 'ch05-fall-drag-analytic',
  title: 'Computed and calculated',
  chapter: 5,
  tags: ['gravity', 'drag', 'integrators'],
  about:
    'Some motions can be calculated on paper: for a fall with drag there is a formula. The blue ball does not know it; it only knows its forces, and takes sixty small steps a second. The ring follows the formula. That both agree is the best proof that the program is right, also for motions without a formula.',
  duration: 25,
  parameters: {
    gravity: { label: 'Gravity', unit: 'px/s²', initial: 10, min: 1, max: 12 },
    drag: { label: 'Drag coefficient', unit: 'kg/s', initial: 0.5, min: 0.3, max: 2 },
  },
  build({ gravity, drag }, { integrator = velocityVerlet }) {
    const forces = [uniformGravity({ y: gravity }), linearDrag()];
    const world = createPhysicsWorld({ capacity: 4, forces, integrator });
    const ball = spawn(world, { position: { y: START }, velocity: {}, mass: 1, collider: 15, linearDrag: drag });
    const without = spawn(world, { position: { x: 120, y: START }, velocity: {}, mass: 1, collider: 15 });
    return { world, dt: 1 / 60, ball, without };
  },
  picture: ({ world, ball, without }, values) => ({
    yDown: true,
    view: { minX: -250, maxX: 400, minY: 0, maxY: 500 },
    curves: [
      {
        points: [],
        now: (t) => ({ x: 0, y: START + exactWay(t, values) }),
        markRadius: 20,
        label: 'formula',
        color: COLORS.white,
      },
    ],
    trails: [ball, without].map((body) => ({ body, length: 900 })),
    arrows: [velocityArrow(world, ball, 3)],
    labels: [{ at: { x: 145, y: START + 8 }, text: 'without drag', color: COLORS.grey }],
  }),
  plots: (plot) => [
    plot('Distance fallen', 's, px', {
      label: 'stepped',
      value: ({ world, ball }) => positionOf(world, ball).y - START,
      exact: exactWay,
    }),
    plot('Velocity', 'v, px/s', {
      label: 'stepped',
      value: ({ world, ball }) => velocityOf(world, ball).y,
      exact: exactSpeed,
    }),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Distance after 10 s',
      { exact: (values) => exactWay(10, values), unit: 'px', relative: 1e-4 },
      ({ world, ball }) => positionOf(world, ball).y - START,
    ),
    at(
      10,
      'Velocity after 10 s',
      { exact: (values) => exactSpeed(10, values), unit: 'px/s', relative: 1e-4 },
      ({ world, ball }) => velocityOf(world, ball).y,
    ),
    at(
      10,
      'Distance after 10 s by the simplest scheme',
      { exact: 160.27, unit: 'px', relative: 1e-3, integrator: positionFirstEuler },
      ({ world, ball }) => positionOf(world, ball).y - START,
    ),
    at(
      10,
      'Velocity after 10 s by the simplest scheme',
      { exact: 19.8652, unit: 'px/s', relative: 1e-3, integrator: positionFirstEuler },
      ({ world, ball }) => velocityOf(world, ball).y,
    ),
  ],
  tryThis: [
    'Choose position-first Euler: its figures are a little off, but not by more than a thousandth.',
    'Make the drag larger: the terminal velocity, gravity over drag, is smaller, and is reached sooner.',
  ],
});
