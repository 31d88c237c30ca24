import { box, circle, createRandom, keepState, polygon } from '@principia/physics';
import type { SceneRun } from '../../scene.ts';
import { choiceOf, defineExample } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

/** Points drawn in each step. */
const BATCH = 100;
const MAX_SHOWN = 1500;
const HALF = { x: 70, y: 60 };

const SHAPES = [
  { name: 'box of 100 by 50', shape: box(100, 50) },
  { name: 'disc of radius 50', shape: circle(50) },
  { name: 'triangle', shape: polygon([{ x: 0 }, { x: 100 }, { x: 0, y: 80 }]) },
  {
    name: 'pentagon',
    shape: polygon([
      { x: -50, y: -50 },
      { x: 50, y: -50 },
      { x: 58, y: 0 },
      { x: 50, y: 50 },
      { x: -50, y: 50 },
    ]),
  },
] as const;

interface Run extends SceneRun {
  /** The last points that hit. */
  readonly shown: readonly Point[];
  /** Mean of r² of all points that hit, and its exact value. */
  readonly estimate: () => number;
  readonly exact: number;
}

/** Whether a point is in the shape, which is about its centre of mass. */
function isInside({ x, y }: Point, index: number): boolean {
  const { vertices, radius } = SHAPES[index].shape;
  const count = vertices.length / 2;
  if (count < 3) return x * x + y * y <= radius * radius;
  for (let i = 0; i < count; i++) {
    const [ax, ay] = [vertices[2 * i], vertices[2 * i + 1]];
    const next = (i + 1) % count;
    const [bx, by] = [vertices[2 * next], vertices[2 * next + 1]];
    if ((bx - ax) * (y - ay) - (by - ay) * (x - ax) < 0) return false;
  }
  return true;
}

export default defineExample({
  id: 'ch13-moment-of-inertia',
  title: 'Measure inertia with random points',
  chapter: 13,
  tags: ['moment of inertia', 'random', 'shapes'],
  about:
    'How hard a body is to turn depends on how far its mass is from the axis: the moment of inertia is the mean of r², times the mass. Here points rain on the shape at random, and the mean of r² of those that hit comes nearer and nearer to the exact one.',
  duration: 20,
  parameters: {
    shape: choiceOf(
      'Shape',
      SHAPES.map(({ name }) => name),
    ),
  },
  presets: SHAPES.slice(1).map(({ name }, i) => ({ label: name, values: { shape: i + 1 } })),
  build({ shape }, { seed }): Run {
    const world = emptyWorld();
    const random = createRandom(seed);
    const sums = { hits: 0, squares: 0, thrown: 0 };
    const shown = Array.from({ length: MAX_SHOWN }, () => ({ x: 0, y: 0 }));
    keepState(world, random.state, sums);
    world.phases.input.push(() => {
      for (let i = 0; i < BATCH; i++) {
        const [x, y] = [random.uniform(-HALF.x, HALF.x), random.uniform(-HALF.y, HALF.y)];
        sums.thrown++;
        if (!isInside({ x, y }, shape)) continue;
        const dot = shown[sums.hits++ % MAX_SHOWN];
        sums.squares += x * x + y * y;
        dot.x = x;
        dot.y = y;
      }
    });
    const estimate = () => (sums.hits === 0 ? 0 : sums.squares / sums.hits);
    return { world, dt: 1 / 60, shown, estimate, exact: SHAPES[shape].shape.inertiaPerMass };
  },
  picture({ shown, estimate, exact }) {
    return {
      view: { minX: -100, maxX: 100, minY: -75, maxY: 75 },
      dots: [
        ...shown.slice(0, 400).map((dot) => ({ at: () => dot, radius: 1.5, color: COLORS.blue })),
        { at: { x: 0, y: 0 }, radius: 6, color: COLORS.orange },
      ],
      labels: [
        { at: { x: -95, y: 68 }, text: () => `mean of r²: ${estimate().toFixed(1)} px²` },
        { at: { x: -95, y: 60 }, text: `exact: ${exact.toFixed(1)} px²` },
      ],
    };
  },
  plots: (plot) => [
    plot('Moment of inertia by mass', 'I/m, px²', {
      label: 'of the points',
      value: ({ estimate }) => estimate(),
      exact: (_, { shape }) => SHAPES[shape].shape.inertiaPerMass,
    }),
  ],
  checks: ({ at }) => [
    at(
      0,
      'Exact moment of the box, (w² + h²)/12',
      { exact: 3125 / 3, unit: 'px²', relative: 1e-6 },
      ({ exact }) => exact,
    ),
    at(20, 'The same by random points', { exact: 3125 / 3, unit: 'px²', relative: 0.01 }, ({ estimate }) => estimate()),
    at(
      0,
      'Exact moment of the disc, r²/2',
      { exact: 1250, unit: 'px²', relative: 1e-9, preset: 'disc of radius 50' },
      ({ exact }) => exact,
    ),
    ...(['triangle', 'pentagon'] as const).map((preset) =>
      at(
        20,
        `Random points by the formula, ${preset}`,
        { exact: 1, relative: 0.01, preset },
        ({ estimate, exact }) => estimate() / exact,
      ),
    ),
  ],
  tryThis: [
    'Compare box and disc: both are 100 px long, but the disc is harder to turn, for more of it is far from the middle.',
    'Watch the plot: to halve its error takes four times as many points.',
  ],
});
