import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { graphOf, slopeOf } from '../support/functions.ts';
import { emptyWorld } from '../support/read.ts';

export default defineExample({
  id: 'ch03-straight-line',
  title: 'A straight line',
  chapter: 3,
  tags: ['functions', 'graph', 'slope'],
  about:
    'The line y = m x + c rises by m for each step of 1 to the right, and crosses the y axis at c. The little staircase moves along the line: wherever it stands, its step has the same height. That is what makes the line straight.',
  duration: 6,
  parameters: {
    slope: { label: 'Slope m', initial: 2, min: -3, max: 3 },
    intercept: { label: 'Height c at x = 0', initial: 1, min: -3, max: 3 },
  },
  presets: [
    { label: 'Level', values: { slope: 0 } },
    { label: 'Downhill', values: { slope: -1 } },
  ],
  build({ slope, intercept }: ValuesOf<'slope' | 'intercept'>) {
    const world = emptyWorld();
    // The staircase goes to and fro between -2 and 1.
    const x = () => -2 + Math.abs(((world.time + 3) % 6) - 3);
    return { world, dt: 1 / 60, x, f: (at: number) => slope * at + intercept };
  },
  picture: ({ x, f }) => ({
    graph: { x: { label: 'x', step: 1 }, y: { label: 'y', step: 1 } },
    view: { minX: -2.5, maxX: 2.5, minY: -5, maxY: 6 },
    curves: [{ points: graphOf(f, -2.5, 2.5, 1), color: COLORS.blue }],
    lines: [
      { from: () => ({ x: x(), y: f(x()) }), to: () => ({ x: x() + 1, y: f(x()) }), color: COLORS.green },
      { from: () => ({ x: x() + 1, y: f(x()) }), to: () => ({ x: x() + 1, y: f(x() + 1) }), color: COLORS.orange },
    ],
    dots: [{ at: () => ({ x: x(), y: f(x()) }) }],
    labels: [
      { at: () => ({ x: x() + 0.4, y: f(x()) }), text: '1', color: COLORS.green },
      { at: () => ({ x: x() + 1.04, y: f(x() + 0.5) }), text: 'm', color: COLORS.orange },
    ],
  }),
  plots: [
    {
      title: 'Height of the dot',
      x: { label: 'x', value: ({ x }) => x() },
      y: { label: 'y' },
      series: [{ label: 'y', value: ({ x, f }) => f(x()) }],
    },
  ],
  checks: ({ at, largest }) => [
    largest(6, 'Slope, from two neighbouring points', { exact: ({ slope }) => slope, absolute: 1e-12 }, ({ x, f }) =>
      slopeOf(f, x(), 0.5),
    ),
    at(0, 'Where it crosses the y axis', { exact: ({ intercept }) => intercept, absolute: 1e-12 }, ({ f }) => f(0)),
  ],
  tryThis: [
    'Change c: the whole line moves up or down, and stays as steep as it was.',
    'Give m the other sign: the line falls as steeply as it rose.',
  ],
});
