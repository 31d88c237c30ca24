import {
  buoyancy,
  createPhysicsWorld,
  createRandom,
  gusts,
  quadraticDrag,
  rgba,
  spawn,
  uniformGravity,
} from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { bubble } from '../support/bubble.ts';
import { velocityOf } from '../support/read.ts';

const HOLD = 0.125;
const UNTIL = 200;
/** Standard deviation of a uniform distribution of half width 1. */
const DEVIATION = 1 / Math.sqrt(3);
/** The mean of N gusts is off by its standard error; three and a half of them are exceeded once in two thousand times. */
const STANDARD_ERRORS = 3.5 / Math.sqrt(UNTIL / HOLD);

export default defineExample({
  id: 'ch07-bubbles-turbulence',
  title: 'Soap bubbles in gusts',
  chapter: 7,
  tags: ['wind', 'turbulence', 'random'],
  about:
    'Eight times a second the wind takes a new direction and strength, by chance. A bubble hardly feels a single gust: it follows their mean, which blows to the right. The heavy ones tremble least. Gusts last a fixed time, and not a frame, so that the same happens on a slow and on a fast computer.',
  duration: UNTIL,
  parameters: {
    mean: { label: 'Mean wind', unit: 'px/s', initial: 20, min: -60, max: 60 },
    spread: { label: 'Largest gust', unit: 'px/s', initial: 500, min: 0, max: 800 },
    count: { label: 'Bubbles', initial: 10, min: 1, max: 100, integer: true },
  },
  presets: [{ label: 'A breeze', values: { spread: 60 } }],
  build({ mean, spread, count }, { seed, ...options }) {
    const gravity = { y: 10 };
    const wind = gusts({ mean: { x: mean }, spread: { x: spread, y: spread }, interval: HOLD, seed });
    const forces = [uniformGravity(gravity), buoyancy({ density: 1, gravity }), quadraticDrag(wind)];
    const world = createPhysicsWorld({ capacity: 110, forces, ...options });
    const random = createRandom(seed);
    const bubbles = Array.from({ length: count }, () => {
      const position = { x: random.uniform(50, 400), y: random.uniform(150, 480) };
      const velocity = { x: random.uniform(-10, 10) };
      return spawn(world, {
        position,
        velocity,
        appearance: rgba(0.4, 0.9, 1, 0.45),
        ...bubble(random.uniform(5, 25)),
      });
    });
    // A function of the package keeps one record of the wind, so that the drawing has a wind of its own.
    const drawn = gusts({ mean: { x: mean }, spread: { x: spread, y: spread }, interval: HOLD, seed });
    return { world, dt: 1 / 60, bubbles, gust: () => ({ ...drawn(world.time) }) };
  },
  picture({ bubbles, gust }) {
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 0, maxY: 500 },
      fills: [{ shape: { minX: -3000, maxX: 4000, minY: -3000, maxY: 3000 }, color: 0x22406b }],
      trails: bubbles.slice(0, 20).map((body) => ({ body, length: 600, interval: 2 })),
      arrows: [{ label: 'wind', from: { x: 350, y: 250 }, vector: gust, scale: 0.3, color: COLORS.yellow }],
    };
  },
  plots: (plot) => [
    plot(
      'Wind and a bubble, along x',
      'velocity, px/s',
      { label: 'wind', value: ({ gust }) => gust().x },
      { label: 'bubble', value: ({ world, bubbles }) => velocityOf(world, bubbles[0]).x },
    ),
  ],
  checks: ({ mean }) => [
    mean(
      UNTIL,
      'Mean wind along x',
      { exact: 20, unit: 'px/s', absolute: 500 * DEVIATION * STANDARD_ERRORS },
      ({ gust }) => gust().x,
    ),
    mean(
      UNTIL,
      'Mean wind along y',
      { exact: 0, unit: 'px/s', absolute: 500 * DEVIATION * STANDARD_ERRORS },
      ({ gust }) => gust().y,
    ),
    // The standard error of a mean square of a uniform distribution is √(4/5N) of it.
    mean(
      UNTIL,
      'Mean square of the wind along y, 500²/3',
      { exact: (500 * 500) / 3, unit: 'px²/s²', relative: Math.sqrt(0.8) * STANDARD_ERRORS },
      ({ gust }) => gust().y * gust().y,
    ),
  ],
  tryThis: [
    'Choose “A breeze”: without strong gusts the bubbles drift smoothly.',
    'Look at the plot: the wind jumps by hundreds of pixels a second, the bubble by a few.',
  ],
});
