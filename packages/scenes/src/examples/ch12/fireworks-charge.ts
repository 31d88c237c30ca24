import { createPhysicsWorld, keepState } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { createSparkChain, SPARK_FORCES } from '../support/spark-chain.ts';

const ORIGIN = { x: 350, y: 250 };
const COPIES = 25;

/** Two sparks for each whole second of holding. */
const sparksOf = (held: number) => 2 * Math.floor(held);

export default defineExample({
  id: 'ch12-fireworks-charge',
  title: 'Charge your fireworks',
  chapter: 12,
  tags: ['particles', 'random', 'growth', 'control'],
  about:
    'Hold the key: for each whole second that you hold it, two sparks more will fly when you let go, and each of these n sparks bursts into n again. Half of those, on average, burst a last time before the show is over: n + n² + n³/2 in all. So a second more makes far more than two sparks more: 10 in all after one second, 52 after two, about 610 after five.',
  duration: 11,
  parameters: {
    held: { label: 'The first is held for', unit: 's', initial: 2.5, min: 0, max: 5.9 },
    copies: { label: 'At once', initial: 1, min: 1, max: COPIES, integer: true },
  },
  presets: [
    { label: 'Twenty-five at once', values: { copies: COPIES } },
    { label: 'Twenty-five small ones', values: { held: 1.5, copies: COPIES } },
    { label: 'Held too short', values: { held: 0.9 } },
  ],
  build({ held, copies }, { seed, ...options }) {
    const most = copies * 1111;
    const world = createPhysicsWorld({ capacity: most + 100, seed, forces: SPARK_FORCES, ...options });
    const chain = createSparkChain(world, most);
    const count = sparksOf(held);
    if (count > 0) chain.launch(ORIGIN, count, copies);
    const hand = { since: -1 };
    keepState(world, hand);
    const charge = () => (hand.since < 0 ? 0 : Math.min(5.9, world.time - hand.since));
    const release = (at: Point) => {
      if (sparksOf(charge()) > 0) chain.launch(at, sparksOf(charge()));
      hand.since = -1;
    };
    return { world, dt: 1 / 60, chain, copies, hand, charge, release };
  },
  picture({ chain, charge }) {
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 0, maxY: 500 },
      lines: [
        {
          from: { x: 250, y: 480 },
          to: () => ({ x: 250 + 40 * charge(), y: 480 }),
          width: 10,
          color: COLORS.orange,
        },
      ],
      labels: [
        { at: { x: 20, y: 480 }, text: () => `${chain.alive()} sparks` },
        { at: { x: 500, y: 480 }, text: () => (charge() > 0 ? `${sparksOf(charge())} when you let go` : '') },
      ],
    };
  },
  actions: {
    action: {
      label: 'Charge',
      about: 'hold to charge, release to fire',
      key: 'f',
      press({ world, hand }) {
        hand.since = world.time;
      },
      release: ({ release }) => release(ORIGIN),
    },
  },
  pointer: {
    about: 'hold to charge, release to fire from there',
    press({ world, hand }) {
      hand.since = world.time;
    },
    release: ({ release }, at) => release(at),
    cancel({ hand }) {
      hand.since = -1;
    },
  },
  plots: (plot) => [plot('Sparks', 'number', { label: 'alive', value: ({ chain }) => chain.alive() })],
  checks: ({ at }) => [
    at(
      1,
      'Sparks of the first burst, 2 for each whole second',
      { exact: ({ held, copies }) => copies * sparksOf(held), absolute: 0 },
      ({ chain }) => chain.born(),
    ),
    // Of 4 × 4 sparks half burst into 4: the deviation is 4 √8 for each of 25; three and a half standard errors.
    at(
      10.5,
      'Born in all, on average of 25 that were held for 2.5 s',
      { exact: 52, absolute: (3.5 * 4 * Math.sqrt(8)) / 5, preset: 'Twenty-five at once' },
      ({ chain, copies }) => chain.born() / copies,
    ),
    // Of 2 × 2 sparks half burst into 2: 2 (1/3 + 1/3) of them is the variance.
    at(
      10.5,
      'Born in all, on average of 25 that were held for 1.5 s',
      { exact: 10, absolute: (3.5 * 2 * Math.sqrt(4 / 3)) / 5, preset: 'Twenty-five small ones' },
      ({ chain, copies }) => chain.born() / copies,
    ),
    at(5, 'Born if held for less than a second', { exact: 0, absolute: 0, preset: 'Held too short' }, ({ chain }) =>
      chain.born(),
    ),
  ],
  tryThis: [
    'Hold the key, or press the picture, for five seconds, and then let go.',
    'Let go a moment before a full second: the started second does not count.',
  ],
});
