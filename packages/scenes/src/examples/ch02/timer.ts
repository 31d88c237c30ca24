import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { discOnLine, placeAfter } from '../support/disc-steps.ts';
import { emptyWorld } from '../support/read.ts';

export default defineExample({
  id: 'ch02-timer',
  title: 'A clock that ticks',
  chapter: 2,
  tags: ['time', 'uniform motion'],
  about:
    'The simplest animation: a clock ticks at equal intervals, and at each tick the disc goes on by 2 px. It does not move at all in between; the eye makes a motion of it if the ticks come quickly enough. A longer interval makes it jerk, and slows it down as well.',
  duration: 10,
  parameters: { interval: { label: 'Interval', unit: 'ms', initial: 1000 / 60, min: 5, max: 500, scale: 'log' } },
  presets: [{ label: 'Twice a second', values: { interval: 500 } }],
  build({ interval }: ValuesOf<'interval'>) {
    const world = emptyWorld();
    // The tolerance is for sums of steps.
    const ticks = () => Math.floor((world.time * 1000) / interval + 1e-6);
    return { world, dt: 1 / 240, ticks, x: () => placeAfter(ticks()) };
  },
  picture: ({ ticks, x }) => discOnLine(x, COLORS.blue, () => `tick ${ticks()}`),
  plots: (plot) => [
    plot('Place of the disc', 'x, px', {
      label: 'x',
      value: ({ x }) => x(),
      exact: (t, { interval }) => placeAfter((1000 * t) / interval),
    }),
  ],
  checks: ({ at }) => [
    at(10, 'Place after n = 600 ticks, 50 + 2 n', { exact: 1250, unit: 'px', absolute: 0 }, ({ x }) => x()),
  ],
  tryThis: [
    'Choose “Twice a second”, and look at the plot: a staircase instead of a slope.',
    'Find the longest interval at which you still see a motion and not a row of places.',
  ],
});
