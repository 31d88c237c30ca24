import { createPhysicsWorld } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { createSparkChain, SPARK_FORCES } from '../support/spark-chain.ts';

/** Of ten times ten sparks of the second generation half are expected to burst; the deviation is 10 of them. */
const [EXPECTED, DEVIATION] = [10 + 100 + 500, 100];

export default defineExample({
  id: 'ch12-fireworks',
  title: 'Sparks that become fireworks',
  chapter: 12,
  tags: ['particles', 'random', 'growth'],
  about:
    'Ten sparks glow for two to four seconds, and each then bursts into ten new ones. After six seconds no spark bursts any more. Ten become a hundred, and of those about half are in time to burst again: some six hundred in all, after ten seconds none.',
  duration: 11,
  parameters: {
    count: { label: 'Sparks of a burst', initial: 10, min: 1, max: 12, integer: true },
    copies: { label: 'Fireworks at once', initial: 1, min: 1, max: 9, integer: true },
  },
  presets: [
    { label: 'Small bursts', values: { count: 4 } },
    { label: 'Nine at once', values: { copies: 9 } },
  ],
  build({ count, copies }, { seed, ...options }) {
    const world = createPhysicsWorld({ capacity: 2600 * copies, seed, forces: SPARK_FORCES, ...options });
    const chain = createSparkChain(world, 2000 * copies);
    chain.launch({ x: 350, y: 200 }, count, copies);
    return { world, dt: 1 / 60, chain, copies };
  },
  picture({ chain }) {
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 0, maxY: 500 },
      labels: [{ at: { x: 20, y: 480 }, text: () => `${chain.alive()} sparks, ${chain.born()} born` }],
    };
  },
  plots: (plot) => [
    plot(
      'Sparks',
      'number',
      { label: 'alive', value: ({ chain }) => chain.alive() },
      { label: 'born', value: ({ chain }) => chain.born() },
    ),
  ],
  checks: ({ at, largest }) => [
    at(1, 'Sparks at first', { exact: ({ count, copies }) => copies * count, absolute: 0 }, ({ chain }) =>
      chain.alive(),
    ),
    // Three and a half standard deviations.
    at(
      10.5,
      'Sparks born in all: 10 + 100, and 500 expected',
      { exact: EXPECTED, absolute: 3.5 * DEVIATION },
      ({ chain }) => chain.born(),
    ),
    // A third of that of one.
    at(
      10.5,
      'Born in all, on average of nine: 613 were counted in 300 others',
      { exact: 613, absolute: (3.5 * DEVIATION) / 3, preset: 'Nine at once' },
      ({ chain, copies }) => chain.born() / copies,
    ),
    largest(
      10.5,
      'Most at a time, on average of nine: 553 in 300 others',
      { exact: 553, absolute: (3.5 * DEVIATION) / 3, preset: 'Nine at once' },
      ({ chain, copies }) => chain.alive() / copies,
    ),
    at(
      10.1,
      'Sparks after 10.1 s: the last was born before 6 s and lived 4 s at most',
      { exact: 0, absolute: 0 },
      ({ chain }) => chain.alive(),
    ),
  ],
  tryThis: [
    'Halve the sparks of a burst: there are six or seven times fewer in all, because there are three generations.',
    'Start anew a few times with another seed: the number in all lies between about three hundred and nine hundred.',
  ],
});
