import { exp, sin } from '@principia/physics';
import { choiceOf, defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { graphOf, largestOf, type RealFunction } from '../support/functions.ts';
import { emptyWorld } from '../support/read.ts';

const ROOTS = [-3.6, -2.5, -1, 0.5, 2, 3.5];
const hilly: RealFunction = (x) => ROOTS.reduce((product, root) => product * (x - root), exp((-x * x) / 4));
const CHOICES = [
  { name: 'Hills between six zeros', f: hilly },
  { name: 'A sine wave', f: (x: number) => 40 * sin(x) },
  { name: 'A single bump', f: (x: number) => 45 * exp(-x * x) },
];

/** The dot moves by 0.02 in each of 60 ticks a second. */
const SPEED = 1.2;

export default defineExample({
  id: 'ch03-move-curve',
  title: 'A dot follows a curve',
  chapter: 3,
  tags: ['functions', 'animation'],
  about:
    'The dot moves evenly to the right, and up or down as the function says. The curve is a product of six factors, one for each zero, times a bell curve that makes it flat far out. Change sides at a zero, and the curve changes its sign.',
  duration: 20 / SPEED,
  ends: true,
  parameters: {
    curve: choiceOf(
      'Function',
      CHOICES.map(({ name }) => name),
    ),
  },
  presets: CHOICES.slice(1).map(({ name }, i) => ({ label: name, values: { curve: i + 1 } })),
  build({ curve }: ValuesOf<'curve'>) {
    const [world, { f }] = [emptyWorld(), CHOICES[curve]];
    const at = () => ({ x: -10 + SPEED * world.time, y: f(-10 + SPEED * world.time) });
    return { world, dt: 1 / 60, f, at };
  },
  picture: ({ f, at }) => ({
    graph: { x: { label: 'x', step: 2 }, y: { label: 'y', step: 20 } },
    view: { minX: -10, maxX: 10, minY: -50, maxY: 50 },
    curves: [{ points: graphOf(f, -10, 10, 1000), color: COLORS.red }],
    lines: [{ from: () => ({ x: at().x, y: 0 }), to: at, color: COLORS.grey, width: 1 }],
    dots: [{ at, color: COLORS.blue, radius: 8 }],
  }),
  plots: (plot) => [plot('Height of the dot', 'y', { label: 'y', value: ({ at }) => at().y })],
  checks: ({ at }) => [
    at(10 / SPEED, 'Height of the dot as it passes x = 0', { exact: -31.5, absolute: 1e-9 }, ({ at }) => at().y),
    at(0, 'Largest value at the six zeros', { exact: 0, absolute: 0 }, () =>
      Math.max(...ROOTS.map((x) => Math.abs(hilly(x)))),
    ),
    at(0, 'Largest value beyond ±9', { exact: 0, absolute: 0.01 }, () =>
      Math.max(largestOf(hilly, -10, -9), largestOf(hilly, 9, 10)),
    ),
  ],
  tryThis: [
    'Watch the speed of the dot: it moves to the right evenly, and yet races where the curve is steep.',
    'Choose the sine wave: the dot bobs like a float on water.',
  ],
});
