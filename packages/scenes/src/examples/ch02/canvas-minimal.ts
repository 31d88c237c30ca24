import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

const [WIDTH, HEIGHT] = [700, 500];

export default defineExample({
  id: 'ch02-canvas-minimal',
  title: 'An empty sheet',
  chapter: 2,
  tags: ['drawing', 'coordinates'],
  about:
    'All drawing begins with an empty sheet, here of 700 by 500 pixels, and with two numbers for each place on it: x counts from the left edge to the right, y from the upper edge downwards. A dot walks round the sheet and says where it is.',
  duration: 24,
  parameters: { speed: { label: 'Speed of the dot', unit: 'px/s', initial: 100, min: 10, max: 400 } },
  build({ speed }: ValuesOf<'speed'>) {
    const world = emptyWorld();
    /** Clockwise from the upper left corner. */
    const place = () => {
      const way = (speed * world.time) % (2 * (WIDTH + HEIGHT));
      if (way < WIDTH) return { x: way, y: 0 };
      if (way < WIDTH + HEIGHT) return { x: WIDTH, y: way - WIDTH };
      if (way < 2 * WIDTH + HEIGHT) return { x: 2 * WIDTH + HEIGHT - way, y: HEIGHT };
      return { x: 0, y: 2 * (WIDTH + HEIGHT) - way };
    };
    return { world, dt: 1 / 60, place };
  },
  picture: ({ place }) => ({
    yDown: true,
    view: { minX: -60, maxX: WIDTH + 60, minY: -50, maxY: HEIGHT + 50 },
    fills: [
      { shape: { minX: -900, maxX: 1600, minY: -900, maxY: 1400 }, color: COLORS.ground },
      { shape: { minX: 0, maxX: WIDTH, minY: 0, maxY: HEIGHT }, color: 0xffffff },
    ],
    dots: [{ at: place, radius: 9, color: COLORS.red }],
    labels: [
      { at: { x: 8, y: -14 }, text: '(0, 0)' },
      { at: { x: WIDTH - 90, y: HEIGHT + 30 }, text: `(${WIDTH}, ${HEIGHT})` },
      {
        at: { x: 260, y: -14 },
        text: () => `the dot is at (${place().x.toFixed(0)}, ${place().y.toFixed(0)})`,
        color: COLORS.yellow,
      },
    ],
  }),
  plots: (plot) => [
    plot(
      'Place of the dot',
      'place, px',
      { label: 'x', value: ({ place }) => place().x },
      { label: 'y', value: ({ place }) => place().y },
    ),
  ],
  checks: ({ at, largest }) => [
    // Sums of 1440 steps are off by rounding.
    at(
      24,
      'Time once round the sheet, 2 (700 + 500) px at 100 px/s: distance of the dot from the corner',
      { exact: 0, unit: 'px', absolute: 1e-6 },
      ({ place }) => place().x + place().y,
    ),
    largest(24, 'Lowest place of the dot, y', { exact: HEIGHT, unit: 'px', absolute: 0 }, ({ place }) => place().y),
  ],
  tryThis: ['Follow y while the dot goes down the right side: it grows, against the habit of mathematics.'],
});
