import { createPhysicsWorld, dormandPrince, energy, log, uniformGravity } from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { type BuildOptions, defineExample, type ValuesOf } from '../define-example.ts';
import { addDoublePendulum, type DoublePendulum, rodTensions } from '../support/double-pendulum.ts';
import { rainbow, rainbowColor } from '../support/rainbow.ts';
import { distanceBetween, positionOf } from '../support/read.ts';

type Values = ValuesOf<'count' | 'first' | 'second' | 'difference'>;

interface Run extends SceneRun {
  readonly pendulums: readonly DoublePendulum[];
  readonly spread: () => number;
  readonly lengthError: () => number;
  readonly start: number;
}

const GRAVITY = 9.81;
const ORIGIN = { x: 0, y: 0 };
/** The period of small swings to the same side (−) and to opposite sides (+), 2π/√((2 ∓ √2) g/L). */
const periodOf = (sign: 1 | -1) => (2 * Math.PI) / Math.sqrt((2 + sign * Math.SQRT2) * GRAVITY);

export default defineExample({
  id: 'ch17-double-pendulums',
  title: 'Fifty double pendulums part',
  chapter: 17,
  tags: ['pendulum', 'chaos', 'energy'],
  about:
    'Fifty pendulums, each hanging on another one, start together: the angles of neighbours differ by a thousandth of a degree. They swing as one for some seconds, then open like a fan, and soon each goes its own way. Nothing here is random: the law is simple, and still what comes next cannot be foretold for long. That is chaos.',
  duration: 30,
  parameters: {
    count: { label: 'Pendulums', initial: 50, min: 2, max: 200, integer: true },
    first: { label: 'Angle of the first rod', unit: '°', initial: 120, min: -179, max: 179 },
    second: { label: 'Angle of the second rod', unit: '°', initial: 150, min: -179, max: 179 },
    difference: { label: 'Difference of neighbours', unit: '°', initial: 1e-3, min: 1e-9, max: 1, scale: 'log' },
  },
  presets: [
    { label: 'A millionth of the difference', values: { difference: 1e-9 } },
    { label: 'A small swing to one side', values: { first: 0.2, second: 0.2 * Math.SQRT2 } },
    { label: 'A small swing to opposite sides', values: { first: 0.2, second: -0.2 * Math.SQRT2 } },
  ],
  build({ count, first, second, difference }: Values, { integrator = dormandPrince() }: BuildOptions): Run {
    const pendulums: DoublePendulum[] = [];
    const forces = [uniformGravity({ y: -GRAVITY }), rodTensions(pendulums, GRAVITY)];
    const world = createPhysicsWorld({ capacity: 410, forces, integrator });
    for (let i = 0; i < count; i++) {
      const angles = [first, second].map((angle) => ((angle + i * difference) * Math.PI) / 180);
      pendulums.push(addDoublePendulum(world, [angles[0], angles[1]], rainbow(i / (count - 1))));
    }
    const last = pendulums[count - 1];
    const spread = () => distanceBetween(positionOf(world, pendulums[0].outer), positionOf(world, last.outer));
    const lengthError = () =>
      pendulums.reduce((most, { inner, outer }) => {
        const [a, b] = [positionOf(world, inner), positionOf(world, outer)];
        return Math.max(most, Math.abs(distanceBetween(a, ORIGIN) - 1), Math.abs(distanceBetween(a, b) - 1));
      }, 0);
    return { world, dt: 1 / 120, pendulums, spread, lengthError, start: energy(world).total };
  },
  picture({ world, pendulums }) {
    const lines = pendulums.flatMap(({ inner, outer }, i) => {
      const line = { color: rainbowColor(i / (pendulums.length - 1)), width: 1.5 };
      const knee = () => positionOf(world, inner);
      return [
        { ...line, from: ORIGIN, to: knee },
        { ...line, from: knee, to: () => positionOf(world, outer) },
      ];
    });
    return { view: { minX: -2.2, maxX: 2.2, minY: -2.15, maxY: 2.15 }, lines, dots: [{ at: ORIGIN, radius: 4 }] };
  },
  plots: (plot) => [
    plot('Distance of the first and the last bob', 'ln(d / 1 m)', { label: 'd', value: ({ spread }) => log(spread()) }),
  ],
  checks: ({ largest }) => [
    largest(
      30,
      'Largest change of the energy of all, per pendulum',
      { exact: 0, unit: 'J', absolute: 1e-5 },
      ({ world, pendulums, start }) => Math.abs(energy(world).total - start) / pendulums.length,
    ),
    largest(30, 'Largest change of the length of a rod', { exact: 0, unit: 'm', absolute: 1e-6 }, ({ lengthError }) =>
      lengthError(),
    ),
    ...([-1, 1] as const).map((sign) => ({
      label: `Period of a small swing, 2π/√((2 ${sign < 0 ? '−' : '+'} √2) g/L)`,
      unit: 's',
      exact: periodOf(sign),
      // Rods that part by 0.5° make the period longer by 10⁻⁵ to 3·10⁻⁵.
      tolerance: { relative: 1e-4 },
      at: { event: ({ world, pendulums }: Run) => positionOf(world, pendulums[0].inner).x, from: 1, to: 2 },
      preset: sign < 0 ? 'A small swing to one side' : 'A small swing to opposite sides',
    })),
  ],
  tryThis: [
    'Choose “A millionth of the difference”: the fan opens only after a quarter of a minute, for the distance grows as an exponential, a straight line in the plot.',
    'Make the first angle 60° and the second 60°: with less energy the pendulums stay together for much longer.',
  ],
});
