import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

type Values = ValuesOf<'v1' | 'v2' | 'interval'>;

const [LEFT, RIGHT, RADIUS] = [100, 420, 40];

export default defineExample({
  id: 'ch11-1d-reposition',
  title: 'Taking two balls apart again',
  chapter: 11,
  tags: ['collision', 'time step'],
  about:
    'A simulation moves in steps, so it finds two balls only when they already overlap. Before it lets them bounce it moves each of them back, by the share of the overlap that its own speed has caused: then they just touch, where they really met. The rings show the places after the repair.',
  duration: 4,
  parameters: {
    v1: { label: 'Velocity of the left', unit: 'px/s', initial: 130, min: 0, max: 300 },
    v2: { label: 'Velocity of the right', unit: 'px/s', initial: -50, min: -300, max: -10 },
    interval: { label: 'Time step', unit: 's', initial: 0.4, min: 0.05, max: 0.5 },
  },
  presets: [{ label: 'Only one moves', values: { v1: 0, v2: -200 } }],
  build({ v1, v2, interval }: Values) {
    const world = emptyWorld();
    /** The first step after which they overlap. */
    const count = Math.floor((RIGHT - LEFT - 2 * RADIUS) / ((v1 - v2) * interval)) + 1;
    const at = (n: number) => [LEFT + v1 * n * interval, RIGHT + v2 * n * interval] as const;
    const [a, b] = at(count);
    const overlap = 2 * RADIUS - (b - a);
    const share = overlap / (v1 - v2);
    const repaired = [a - v1 * share, b - v2 * share] as const;
    /** Shown in slow motion: they stay where they were found. */
    const shown = () => at(Math.min(count, Math.floor(world.time / interval + 1e-9)));
    return { world, dt: 1 / 60, shown, repaired, overlap, found: count * interval };
  },
  picture({ world, shown, repaired, overlap, found }) {
    const disc = (i: 0 | 1, color: number) => ({
      shape: { centre: () => ({ x: shown()[i], y: 0 }), radius: RADIUS },
      color,
      opacity: 0.7,
    });
    const ring = (x: number) => ({ points: [], now: () => ({ x, y: 0 }), markRadius: RADIUS, color: COLORS.white });
    return {
      view: { minX: 0, maxX: 520, minY: -140, maxY: 140 },
      fills: [disc(0, COLORS.red), disc(1, COLORS.blue)],
      curves: repaired.map(ring),
      labels: [
        {
          at: { x: 20, y: -115 },
          text: () => (world.time < found ? 'on their way' : `they overlap by ${overlap.toFixed(1)} px`),
        },
      ],
    };
  },
  plots: (plot) => [
    plot('Gap between the balls', 'gap, px', {
      label: 'in steps',
      value: ({ shown }) => shown()[1] - shown()[0] - 2 * RADIUS,
    }),
  ],
  checks: ({ at }) => [
    at(
      0,
      'Gap after the repair',
      { exact: 0, unit: 'px', absolute: 1e-12 },
      ({ repaired }) => repaired[1] - repaired[0] - 2 * RADIUS,
    ),
    at(
      0,
      'Place of the left ball: where they met, v₁ times the time of approach',
      { exact: ({ v1, v2 }) => LEFT + (v1 * (RIGHT - LEFT - 2 * RADIUS)) / (v1 - v2), unit: 'px', absolute: 1e-10 },
      ({ repaired }) => repaired[0],
    ),
    at(
      0,
      'Gap after the repair if only one moves',
      { exact: 0, unit: 'px', absolute: 1e-12, preset: 'Only one moves' },
      ({ repaired }) => repaired[1] - repaired[0] - 2 * RADIUS,
    ),
  ],
  tryThis: [
    'Make the step longer: the overlap grows, the place of the meeting stays.',
    'Choose “Only one moves”: the one at rest is left where it is.',
  ],
});
