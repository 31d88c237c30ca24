import { defineExample, type ValuesOf } from '../define-example.ts';
import { frameOf } from '../frame.ts';
import { COLORS } from '../picture.ts';
import { graphOf, largestOf } from '../support/functions.ts';
import { emptyWorld } from '../support/read.ts';

const VIEW = { minX: -4, maxX: 4, minY: 0, maxY: 20 };
const square = (x: number) => x * x;

/** Height of the polygon through equally spaced points of the parabola. */
function polygonAt(x: number, points: number): number {
  const width = 8 / (points - 1);
  const left = -4 + width * Math.min(points - 2, Math.floor((x + 4) / width));
  return square(left) + ((x - left) * (square(left + width) - square(left))) / width;
}

export default defineExample({
  id: 'ch03-graph-plotter',
  title: 'Drawing a graph from dots',
  chapter: 3,
  tags: ['functions', 'graph'],
  about:
    'A computer draws a curve like a child that joins numbered dots: it computes some points, and draws straight lines between them. Nine points make the parabola y = x² look like a bent wire; a hundred and one, and no eye sees the corners any more. With half the distance of the dots the error is a quarter.',
  duration: 8,
  ends: true,
  parameters: { points: { label: 'Number of dots', initial: 9, min: 3, max: 101, integer: true } },
  presets: [{ label: 'A smooth curve', values: { points: 101 } }],
  build: ({ points }: ValuesOf<'points'>) => ({ world: emptyWorld(), dt: 1 / 60, points }),
  picture({ world }, { points }) {
    const x = () => -4 + world.time;
    const dots = graphOf(square, -4, 4, points - 1);
    return {
      graph: { x: { label: 'x', step: 1 }, y: { label: 'y', step: 5 } },
      view: VIEW,
      curves: [
        { points: graphOf(square, -4, 4), color: COLORS.red },
        { points: dots, color: COLORS.blue },
      ],
      dots: [
        ...dots.map((at) => ({ at, radius: points > 30 ? 2.5 : 5, color: COLORS.blue })),
        { at: () => ({ x: x(), y: polygonAt(x(), points) }) },
      ],
      labels: [
        { at: () => ({ x: x(), y: square(x()) }), text: () => `  (${x().toFixed(1)}, ${square(x()).toFixed(1)})` },
      ],
    };
  },
  plots: [
    {
      title: 'How far the lines are above the curve',
      x: { label: 'x', value: ({ world }) => world.time - 4 },
      y: { label: 'error' },
      series: [
        { label: 'nine dots', value: ({ world }) => polygonAt(world.time - 4, 9) - square(world.time - 4) },
        { label: 'seventeen', value: ({ world }) => polygonAt(world.time - 4, 17) - square(world.time - 4) },
      ],
    },
  ],
  checks: ({ at }) => [
    at(
      0,
      'The point (2, 4) on paper of 450 px, from the left edge at 50',
      { exact: 387.5, unit: 'px', absolute: 0 },
      () => 50 + (450 * placeInGraph(2, 4).x) / placeInGraph(4, 20).x,
    ),
    at(
      0,
      'The same on paper of 350 px, from the axis at 380 upwards',
      { exact: 310, unit: 'px', absolute: 0 },
      () => 380 - (350 * placeInGraph(2, 4).y) / placeInGraph(4, 20).y,
    ),
    // Half-way between two dots, among other places.
    at(
      0,
      'Largest error of the lines, (Δx)²/4',
      { exact: ({ points }) => 16 / ((points - 1) * (points - 1)), relative: 1e-9 },
      ({ points }) => largestOf((x) => polygonAt(x, points) - square(x), -4, 4, 2 * (points - 1)),
    ),
  ],
  tryThis: [
    'Take 17 dots instead of 9: the lines are four times as close to the curve.',
    'Take three dots: the parabola becomes a letter V.',
  ],
});

const placeInGraph = (x: number, y: number) =>
  frameOf({ view: VIEW, graph: { x: { label: 'x' }, y: { label: 'y' } } }).place({ x, y });
