import { createPhysicsWorld, exp, linearDrag, rungeKutta4, spawn, springs } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { displacement } from '../support/damped-oscillator.ts';
import { positionOf, velocityOf } from '../support/read.ts';

const CENTRE = 350;
const AMPLITUDE = 250;
/** Damping with which 10 N/m and 1 kg just do not oscillate, 2 √(k m). */
const CRITICAL = 2 * Math.sqrt(10);

/** Exact position of an oscillator of 1 kg that starts at rest. */
const exactX = (t: number, values: ValuesOf<'stiffness' | 'damping'>) =>
  CENTRE + displacement(values, -AMPLITUDE, 0, t);

/** Time between two swings, s, 2π/√(k/m − c²/4m²) for 1 kg; not a number where the damping leaves hardly any. */
function periodOf({ stiffness, damping }: ValuesOf<'stiffness' | 'damping'>): number {
  const gamma = damping / 2;
  return gamma * gamma < stiffness / 2 ? (2 * Math.PI) / Math.sqrt(stiffness - gamma * gamma) : Number.NaN;
}

export default defineExample({
  id: 'ch08-damped',
  title: 'A damped oscillator',
  chapter: 8,
  tags: ['spring', 'oscillation', 'damping'],
  about:
    'A spring pulls the ball to the middle, and drag −c v takes energy from it. The amplitude falls by the same factor in each period, as exp(−c t/2m), and the period is a little longer than without damping.',
  duration: 20,
  parameters: {
    stiffness: { label: 'Stiffness of the spring', unit: 'N/m', initial: 10, min: 1, max: 40 },
    damping: { label: 'Damping c', unit: 'kg/s', initial: 0.5, min: 0, max: 25 },
  },
  presets: [
    { label: 'Critical damping', values: { damping: CRITICAL } },
    { label: 'Strong damping', values: { damping: 20 } },
  ],
  build({ stiffness, damping }, { integrator = rungeKutta4 }) {
    const world = createPhysicsWorld({ capacity: 8, forces: [linearDrag(), springs()], integrator });
    const wall = spawn(world, { position: { x: CENTRE, y: 250 } });
    const at = { x: CENTRE - AMPLITUDE, y: 250 };
    const ball = spawn(world, { position: at, mass: 1, collider: 20, linearDrag: damping });
    spawn(world, { spring: { a: wall, b: ball, stiffness } });
    return { world, dt: 1 / 120, ball };
  },
  picture({ world, ball }, values) {
    const at = () => positionOf(world, ball);
    return {
      view: { minX: 50, maxX: 650, minY: 130, maxY: 370 },
      lines: [
        { from: { x: CENTRE, y: 215 }, to: { x: CENTRE, y: 285 }, color: COLORS.grey },
        { from: { x: CENTRE, y: 250 }, to: at, coils: 14, color: COLORS.yellow },
      ],
      curves: [{ points: [], now: (t) => ({ x: exactX(t, values), y: 250 }), markRadius: 20, label: 'exact' }],
      arrows: [{ label: 'v', from: at, vector: () => velocityOf(world, ball), scale: 0.15, color: COLORS.green }],
    };
  },
  plots: (plot) => [
    plot('Displacement', 'x, px', {
      label: 'stepped',
      value: ({ world, ball }) => positionOf(world, ball).x - CENTRE,
      exact: (t, values) => exactX(t, values) - CENTRE,
    }),
    {
      title: 'Velocity against displacement',
      x: { label: 'x, px', value: ({ world, ball }) => positionOf(world, ball).x - CENTRE },
      y: { label: 'v, px/s' },
      series: [{ label: 'path', value: ({ world, ball }) => velocityOf(world, ball).x }],
    },
  ],
  checks: ({ at, largest }) => [
    {
      label: 'Period, 2π/√(k/m − c²/4m²)',
      unit: 's',
      exact: periodOf,
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, ball }) => positionOf(world, ball).x - CENTRE, from: 1, to: 2 },
    },
    at(
      10,
      'Displacement after 10 s',
      { exact: (values) => exactX(10, values) - CENTRE, unit: 'px', absolute: 1e-3 },
      ({ world, ball }) => positionOf(world, ball).x - CENTRE,
    ),
    {
      label: 'Amplitude after one period, exp(−ζ ω T) of the first',
      exact: (values) => exp((-values.damping / 2) * periodOf(values)),
      tolerance: { relative: 1e-3 },
      at: { event: ({ world, ball }) => velocityOf(world, ball).x },
      measure: ({ world, ball }) => (positionOf(world, ball).x - CENTRE) / -AMPLITUDE,
    },
    largest(
      20,
      'Largest displacement to the right: it does not swing through',
      { exact: 0, unit: 'px', absolute: 1e-9, preset: 'Critical damping' },
      ({ world, ball }) => positionOf(world, ball).x - CENTRE,
    ),
    at(
      10,
      'Displacement after 10 s of strong damping: it creeps',
      { exact: (values) => exactX(10, values) - CENTRE, unit: 'px', relative: 1e-3, preset: 'Strong damping' },
      ({ world, ball }) => positionOf(world, ball).x - CENTRE,
    ),
  ],
  tryThis: [
    'Choose “Critical damping”, as in a good door closer: the ball comes to rest soonest without swinging through.',
    'Set the damping to zero: the ball swings for ever.',
    'Watch the second plot: the path winds into the middle; without damping it closes.',
  ],
});
