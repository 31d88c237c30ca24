import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { graphOf, largestOf, slopeOf } from '../support/functions.ts';
import { emptyWorld } from '../support/read.ts';

const f = (x: number) => x * x;
const forward = (x: number, h: number) => (f(x + h) - f(x)) / h;

export default defineExample({
  id: 'ch03-derivative',
  title: 'How steep is it?',
  chapter: 3,
  tags: ['functions', 'derivative', 'accuracy'],
  about:
    'The computer measures the slope of y = x² with two points of the curve. If it takes the dot and one further on (blue), it looks ahead, and finds 2x + h instead of 2x. If it takes one point ahead and one behind (green), the errors cancel, and the slope of a parabola comes out exactly.',
  duration: 10,
  parameters: { h: { label: 'Distance of the points h', initial: 0.3, min: 0.01, max: 1.5 } },
  presets: [{ label: 'Points far apart', values: { h: 1.5 } }],
  build({ h }: ValuesOf<'h'>) {
    const world = emptyWorld();
    const x = () => -2 + 3.5 * (1 - Math.abs(((world.time / 5) % 2) - 1));
    return { world, dt: 1 / 60, h, x };
  },
  picture({ h, x }) {
    const on = (shift: number) => () => ({ x: x() + shift, y: f(x() + shift) });
    // The line through the dot and the next point, drawn beyond both.
    const secant = (side: number) => () => ({ x: x() + side, y: f(x()) + side * forward(x(), h) });
    const tangent = (side: number) => () => ({ x: x() + side, y: f(x()) + side * slopeOf(f, x(), h) });
    return {
      graph: { x: { label: 'x', step: 1 }, y: { label: 'y', step: 2 } },
      view: { minX: -3, maxX: 3, minY: -6, maxY: 9 },
      curves: [
        { points: graphOf(f, -3, 3), color: COLORS.red },
        { points: graphOf((at) => forward(at, h), -3, 3, 1), color: COLORS.blue },
        { points: graphOf((at) => slopeOf(f, at, h), -3, 3, 1), color: COLORS.green },
      ],
      lines: [
        { from: secant(-1), to: secant(1), color: COLORS.blue },
        { from: tangent(-1), to: tangent(1), color: COLORS.green },
      ],
      dots: [
        { at: on(0), color: COLORS.white },
        { at: on(h), color: COLORS.blue, radius: 4 },
        { at: on(-h), color: COLORS.green, radius: 4 },
      ],
      labels: [
        { at: { x: -2.1, y: 5.2 }, text: 'y = x²', color: COLORS.red },
        { at: { x: 0.4, y: -4 }, text: 'slope with one point ahead', color: COLORS.blue },
        { at: { x: 0.4, y: -5 }, text: 'slope with a point on each side', color: COLORS.green },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Error of the slope',
      'error',
      { label: 'one ahead', value: ({ h, x }) => forward(x(), h) - 2 * x() },
      { label: 'both sides', value: ({ h, x }) => slopeOf(f, x(), h) - 2 * x() },
    ),
  ],
  checks: ({ at }) => [
    at(0, 'One point ahead: largest difference from 2x + h', { exact: 0, absolute: 1e-9 }, ({ h }) =>
      largestOf((x) => forward(x, h) - 2 * x - h, -3, 3),
    ),
    at(0, 'Both sides: largest difference from 2x', { exact: 0, absolute: 1e-9 }, ({ h }) =>
      largestOf((x) => slopeOf(f, x, h) - 2 * x, -3, 3),
    ),
  ],
  tryThis: [
    'Halve the distance: the blue error is halved, and the green one was 0 before.',
    'Put the points far apart: the green line is still parallel to the curve at the dot.',
  ],
});
