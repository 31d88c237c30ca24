import { cos, sin } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { distanceBetween, emptyWorld, lengthOf } from '../support/read.ts';

export default defineExample({
  id: 'ch03-move-circle-parametric',
  title: 'Round and round with sine and cosine',
  chapter: 3,
  tags: ['circle', 'sine', 'animation'],
  about:
    'Let x be the sine of an angle and y its cosine, and let the angle grow evenly: the dot goes round and round at the same speed. Its shadows on the two axes swing to and fro. Make the two radii different, and the circle becomes an ellipse.',
  duration: 10 / 0.6,
  parameters: {
    // The angle grows by 0.01 rad in each of 60 ticks a second.
    rate: { label: 'Angle per second', unit: 'rad/s', initial: 0.6, min: 0.1, max: 3 },
    width: { label: 'Radius along x', initial: 1, min: 0.2, max: 1.9 },
    height: { label: 'Radius along y', initial: 1, min: 0.2, max: 1.2 },
  },
  presets: [{ label: 'An ellipse', values: { width: 1.8, height: 0.6 } }],
  build({ rate, width, height }) {
    const world = emptyWorld();
    const place = (angle: number) => ({ x: width * sin(angle), y: height * cos(angle) });
    const at = () => place(rate * world.time);
    const stepLength = () => distanceBetween(at(), place(rate * (world.time - 1 / 60)));
    return { world, dt: 1 / 60, place, at, stepLength };
  },
  picture: ({ place, at }) => ({
    graph: { x: { label: 'x', step: 0.5 }, y: { label: 'y', step: 0.5 } },
    view: { minX: -2, maxX: 2, minY: -1.25, maxY: 1.25 },
    curves: [{ points: pointsOf(place, 0, 2 * Math.PI), color: COLORS.red }],
    lines: [
      { from: { x: 0, y: 0 }, to: at, color: COLORS.grey, width: 1 },
      { from: () => ({ x: at().x, y: 0 }), to: at, color: COLORS.green, width: 1 },
      { from: () => ({ x: 0, y: at().y }), to: at, color: COLORS.orange, width: 1 },
    ],
    dots: [
      { at: () => ({ x: at().x, y: 0 }), color: COLORS.green },
      { at: () => ({ x: 0, y: at().y }), color: COLORS.orange },
      { at, color: COLORS.blue, radius: 8 },
    ],
  }),
  plots: (plot) => [
    plot(
      'The two shadows',
      'x and y',
      { label: 'x', value: ({ at }) => at().x },
      { label: 'y', value: ({ at }) => at().y },
    ),
  ],
  checks: ({ largest, smallest }) => [
    largest(10, 'Longest step of the dot in a tick', { exact: 0.01, relative: 1e-5 }, ({ stepLength }) => stepLength()),
    smallest(10, 'Shortest step', { exact: 0.01, relative: 1e-5 }, ({ stepLength }) => stepLength()),
    largest(
      16,
      'Largest distance from the middle',
      // The farthest place may lie half a tick from one of 60 a second: 1 − cos(3 rad/120) at most.
      { exact: ({ width, height }) => Math.max(width, height), relative: 3.2e-4 },
      ({ at }) => lengthOf(at()),
    ),
    {
      label: 'Time of a turn, 2π over the angle per second',
      unit: 's',
      exact: ({ rate }) => (2 * Math.PI) / rate,
      tolerance: { relative: 1e-5 },
      // At time 0 the dot is at x = 0 as well, on its way to the right.
      at: { event: ({ at }) => at().x },
    },
  ],
  tryThis: [
    'Choose the ellipse: the dot is now fastest where it passes near the middle.',
    'Watch the second graph: sine and cosine are the same wave, a quarter of a turn apart.',
  ],
});
