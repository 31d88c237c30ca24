import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { areaOf, graphOf, leftSumOf } from '../support/functions.ts';
import { emptyWorld } from '../support/read.ts';

const f = (x: number) => 2 * x;

export default defineExample({
  id: 'ch03-integral',
  title: 'Adding up what changes',
  chapter: 3,
  tags: ['functions', 'integral', 'accuracy'],
  about:
    'How far does a car get whose speed changes all the time? Cut the time into short pieces, treat the speed as constant in each, and add up the pieces: the area of the columns under the curve. The sum that starts with 9 at x = −3 follows x². With more and narrower columns the steps disappear.',
  duration: 6,
  ends: true,
  parameters: {
    columns: { label: 'Number of columns', initial: 24, min: 4, max: 200, integer: true, scale: 'log' },
  },
  presets: [{ label: 'Narrow columns', values: { columns: 200 } }],
  build({ columns }: ValuesOf<'columns'>) {
    const world = emptyWorld();
    const width = 6 / columns;
    const x = () => Math.min(3, -3 + world.time);
    // The sum of all columns whose left side the dot has passed.
    const sumTo = (end: number) => {
      const done = Math.round((end + 3) / width);
      return done === 0 ? 9 : 9 + leftSumOf(f, -3, -3 + done * width, done);
    };
    return { world, dt: 1 / 60, columns, width, x, sumTo };
  },
  picture({ columns, width, x, sumTo }) {
    const lefts = Array.from({ length: columns }, (_, i) => -3 + i * width);
    const done = () => -3 + width * Math.floor((x() + 3) / width + 1e-9);
    return {
      graph: { x: { label: 'x', step: 1 }, y: { label: 'y', step: 3 } },
      view: { minX: -3, maxX: 3, minY: -6.5, maxY: 9.5 },
      fills: lefts.map((minX) => ({
        shape: { minX, maxX: minX + 0.92 * width, minY: Math.min(0, f(minX)), maxY: Math.max(0, f(minX)) },
        color: COLORS.red,
        opacity: 0.35,
      })),
      curves: [
        { points: graphOf(f, -3, 3, 1), color: COLORS.red },
        { points: graphOf((at) => at * at, -3, 3), color: COLORS.grey },
        { points: [...lefts, 3].map((at) => ({ x: at, y: sumTo(at) })), color: COLORS.green },
      ],
      dots: [
        { at: () => ({ x: done(), y: f(done()) }), color: COLORS.red },
        { at: () => ({ x: done(), y: sumTo(done()) }), color: COLORS.green },
      ],
      labels: [
        { at: { x: -1.6, y: -5 }, text: 'y = 2x', color: COLORS.red },
        { at: { x: -2.2, y: 6 }, text: 'sum of the columns', color: COLORS.green },
      ],
    };
  },
  plots: [
    {
      title: 'Sum of the columns and x²',
      x: { label: 'x', value: ({ x }) => x() },
      y: { label: 'sum' },
      series: [
        { label: 'columns', value: ({ x, sumTo }) => sumTo(x()) },
        { label: 'x²', value: ({ x }) => x() * x() },
      ],
    },
  ],
  checks: ({ at }) => [
    at(
      6,
      'Error of the columns at the end, −h/2 (f(3) − f(−3))',
      { exact: ({ columns }) => -36 / columns, absolute: 1e-9 },
      ({ sumTo }) => sumTo(3) - 9,
    ),
    at(0, 'The same with a thousand columns', { exact: -0.036, absolute: 1e-9 }, () => leftSumOf(f, -3, 3, 1000)),
    // 0.018 are missing at the start, where x² is 9.018, and 0.036 are lost by the left sides.
    at(
      0,
      'Columns from −3.003 to 2.997, begun with 9: where x² is 8.982',
      { exact: 8.928, absolute: 1e-9 },
      () => 9 + leftSumOf(f, -3.003, 2.997, 1000),
    ),
    at(0, 'With slanting tops instead of level ones', { exact: 0, absolute: 1e-9 }, () => areaOf(f, -3, 3, 1000)),
  ],
  tryThis: [
    'Double the number of columns: the green line is half as far from the grey one.',
    'Take four columns: each is so wide that the sum misses by 9, all of what it should be.',
  ],
});
