import { cos, createPhysicsWorld, electricField, rgba, rungeKutta4, sin, spawn } from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { choiceOf, defineExample } from '../define-example.ts';
import { COLORS, type Point, pointsOf } from '../picture.ts';
import { forceArrow, velocityArrow } from '../support/arrows.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

const START = { x: 100, y: 300 };
const TIME = 25;

/** A field that depends on the time, and how far a unit charge of 1 kg has moved in it from rest. */
interface FieldOverTime {
  readonly name: string;
  readonly field: (t: number) => Point;
  readonly way: (t: number) => Point;
}

/** A swing of frequency ω along y moves a charge by 50 (1 − cos ωt)/ω². */
const swing = (omega: number): FieldOverTime => ({
  name: omega === 1 ? '(0, 50 cos t)' : `(0, 50 cos ${omega}t)`,
  field: (t) => ({ x: 0, y: 50 * cos(omega * t) }),
  way: (t) => ({ x: 0, y: (50 / (omega * omega)) * (1 - cos(omega * t)) }),
});

const FIELDS: readonly FieldOverTime[] = [
  {
    name: '(1, 2t cos t)',
    field: (t) => ({ x: 1, y: 2 * t * cos(t) }),
    way: (t) => ({ x: (t * t) / 2, y: 2 * (2 * sin(t) - t * cos(t) - t) }),
  },
  swing(1),
  swing(2),
  swing(3),
  {
    name: '(1, 50 cos t)',
    field: (t) => ({ x: 1, y: 50 * cos(t) }),
    way: (t) => ({ x: (t * t) / 2, y: 50 * (1 - cos(t)) }),
  },
  {
    name: '(50 cos t, 50 cos t)',
    field: (t) => ({ x: 50 * cos(t), y: 50 * cos(t) }),
    way: (t) => ({ x: 50 * (1 - cos(t)), y: 50 * (1 - cos(t)) }),
  },
  {
    name: '(20 sin t, 20 cos t)',
    field: (t) => ({ x: 20 * sin(t), y: 20 * cos(t) }),
    way: (t) => ({ x: 20 * (t - sin(t)), y: 20 * (1 - cos(t)) }),
  },
  {
    name: '(20 sin(t − 1), 20 cos t)',
    field: (t) => ({ x: 20 * sin(t - 1), y: 20 * cos(t) }),
    way: (t) => ({ x: 20 * (t * cos(1) - sin(t - 1) - sin(1)), y: 20 * (1 - cos(t)) }),
  },
];

interface Run extends SceneRun {
  readonly body: number;
  readonly exact: (t: number) => Point;
  readonly strength: () => Point;
}

export default defineExample({
  id: 'ch10-electric-field',
  title: 'A charge in a changing electric field',
  chapter: 10,
  tags: ['electric field', 'charges', 'motion'],
  about:
    'The same field acts everywhere, and changes with time. It pushes the charge with q E. The field does not set the velocity but its change: so a field that only swings can carry the charge far away, on the path of a point on a rolling wheel.',
  duration: TIME,
  ends: true,
  parameters: {
    field: {
      ...choiceOf(
        'Field E',
        FIELDS.map(({ name }) => name),
      ),
      unit: 'V/px',
    },
    charge: { label: 'Charge q', unit: 'C', initial: 1, min: -2, max: 2 },
  },
  presets: FIELDS.map(({ name }, i) => ({ label: name, values: { field: i } })),
  build({ field, charge }, { integrator = rungeKutta4 }): Run {
    const { field: strength, way } = FIELDS[field];
    const world = createPhysicsWorld({ capacity: 4, forces: [electricField(strength)], integrator });
    const body = spawn(world, { position: START, mass: 1, charge, collider: 8, appearance: rgba(1, 0.7, 0.35) });
    const exact = (t: number) => ({ x: START.x + charge * way(t).x, y: START.y + charge * way(t).y });
    return { world, dt: 1 / 60, body, exact, strength: () => strength(world.time) };
  },
  picture({ world, body, exact, strength }, { charge }) {
    const points = pointsOf(exact, 0, TIME, 500);
    const [xs, ys] = [points.map(({ x }) => x), points.map(({ y }) => y)];
    const force = () => ({ x: charge * strength().x, y: charge * strength().y });
    return {
      yDown: true,
      view: {
        minX: Math.min(...xs) - 40,
        maxX: Math.max(...xs) + 40,
        minY: Math.min(...ys) - 40,
        maxY: Math.max(...ys) + 40,
      },
      curves: [{ points, now: exact, markRadius: 8, label: 'exact', color: COLORS.ground }],
      trails: [{ body, length: 1600 }],
      arrows: [forceArrow(world, body, 'force', force, 1), velocityArrow(world, body, 0.6)],
    };
  },
  plots: (plot) => [
    plot(
      'Field',
      'E, V/px',
      { label: 'along x', value: ({ strength }) => strength().x },
      { label: 'along y', value: ({ strength }) => strength().y },
    ),
    plot('Displacement along y', 'y, px', {
      label: 'stepped',
      value: ({ world, body }) => positionOf(world, body).y - START.y,
      exact: (t, { field, charge }) => charge * FIELDS[field].way(t).y,
    }),
  ],
  checks: ({ at, largest }) => [
    at(
      TIME,
      'Place after 25 s along x',
      { exact: 412.5, unit: 'px', relative: 1e-3 },
      ({ world, body }) => positionOf(world, body).x,
    ),
    at(
      TIME,
      'Place after 25 s along y',
      { exact: 199.91, unit: 'px', relative: 1e-3 },
      ({ world, body }) => positionOf(world, body).y,
    ),
    ...[100, 25, 100 / 9].map((exact, i) =>
      largest(
        TIME,
        'Width of the swing, 100/ω²',
        { exact, unit: 'px', relative: 1e-3, preset: FIELDS[i + 1].name },
        ({ world, body }) => positionOf(world, body).y - START.y,
      ),
    ),
    at(
      TIME,
      'Distance from the exact cycloid after 25 s',
      { exact: 0, unit: 'px', absolute: 1e-4, preset: '(20 sin t, 20 cos t)' },
      ({ world, body, exact }) => distanceBetween(positionOf(world, body), exact(world.time)),
    ),
  ],
  tryThis: [
    'Turn the sign of the charge: it moves the opposite way at every moment.',
    'Compare the three fields (0, 50 cos ωt): twice the frequency makes the swing four times smaller.',
  ],
});
