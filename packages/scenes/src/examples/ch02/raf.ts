import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { discOnLine, placeAfter } from '../support/disc-steps.ts';
import { emptyWorld } from '../support/read.ts';

export default defineExample({
  id: 'ch02-raf',
  title: 'One step for each picture',
  chapter: 2,
  tags: ['time', 'frame rate', 'uniform motion'],
  about:
    'The browser calls before each picture that it shows, and the disc takes a step of 2 px. That is as smooth as can be, with one fault: the speed belongs to the display. On a screen of 144 pictures a second the same game is 2.4 times as fast as on one of 60. A game needs a clock.',
  duration: 10,
  parameters: { rate: { label: 'Pictures a second', unit: 'Hz', initial: 60, min: 24, max: 240, integer: true } },
  presets: [{ label: 'A fast display', values: { rate: 144 } }],
  build({ rate }: ValuesOf<'rate'>) {
    const world = emptyWorld();
    const frames = () => Math.floor(world.time * rate + 1e-6);
    return { world, dt: 1 / 720, frames, x: () => placeAfter(frames()) };
  },
  picture: ({ frames, x }) => discOnLine(x, COLORS.orange, () => `picture ${frames()}`),
  plots: (plot) => [
    plot('Place of the disc', 'x, px', { label: 'x', value: ({ x }) => x(), exact: (t) => placeAfter(60 * t) }),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Place after 10 s, 50 + 2 · 10 · rate',
      { exact: ({ rate }) => 50 + 20 * rate, unit: 'px', absolute: 0 },
      ({ x }) => x(),
    ),
  ],
  tryThis: ['Choose “A fast display”: the thin line of the plot is where the disc would be at 60 pictures a second.'],
});
