import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

const [START, STEP, WIDTH] = [50, 2, 600];

export default defineExample({
  id: 'ch02-raf-throttled',
  title: 'Not more pictures than that',
  chapter: 2,
  tags: ['time', 'frame rate'],
  about:
    'To save the battery a game leaves pictures out: it draws only if enough time has passed since the last one. But the display has a beat of its own, so only every second, third, … of its pictures can be taken. A cap of 60 on a display of 144 gives 48 pictures a second, not 60.',
  duration: 10,
  parameters: {
    rate: { label: 'Pictures of the display', unit: 'Hz', initial: 144, min: 30, max: 240, integer: true },
    cap: { label: 'Cap', unit: 'Hz', initial: 60, min: 10, max: 240, integer: true },
  },
  presets: [{ label: 'A display of 60', values: { rate: 60 } }],
  build({ rate, cap }: ValuesOf<'rate' | 'cap'>) {
    const world = emptyWorld();
    /** Each picture that is shown is so many pictures of the display after the one before. */
    const every = Math.ceil(rate / cap);
    const shown = () => Math.floor(Math.floor(world.time * rate + 1e-6) / every);
    return { world, dt: 1 / 720, shown, x: () => START + STEP * shown() };
  },
  picture: ({ world, shown, x }) => ({
    yDown: true,
    view: { minX: 0, maxX: 700, minY: 120, maxY: 380 },
    lines: [{ from: { x: 0, y: 275 }, to: { x: 700, y: 275 }, color: COLORS.ground }],
    dots: [{ at: () => ({ x: START + ((x() - START) % WIDTH), y: 250 }), radius: 20, color: COLORS.green }],
    labels: [
      {
        at: { x: 30, y: 340 },
        text: () => `${shown()} pictures in ${world.time.toFixed(1)} s`,
      },
    ],
  }),
  plots: [
    {
      title: 'Pictures so far',
      y: { label: 'pictures' },
      series: [{ label: 'shown', value: ({ shown }) => shown(), exact: (t, { cap }) => cap * t }],
    },
  ],
  checks: [
    {
      label: 'Pictures in 10 s: every ⌈rate/cap⌉-th of the display’s',
      unit: '',
      exact: ({ rate, cap }) => Math.floor((10 * rate) / Math.ceil(rate / cap)),
      tolerance: { absolute: 0 },
      at: { time: 10 },
      measure: ({ shown }) => shown(),
    },
    {
      label: 'Pictures in 10 s of a display of 144 with a cap of 60',
      unit: '',
      exact: 480,
      tolerance: { absolute: 0 },
      at: { time: 10 },
      measure: ({ shown }) => shown(),
    },
  ],
  tryThis: ['Raise the cap until it is 72, half of 144: now every second picture is shown, and none is lost.'],
});
