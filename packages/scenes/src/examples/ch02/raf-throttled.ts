import { keepState } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { discOnLine, placeAfter } from '../support/disc-steps.ts';
import { emptyWorld } from '../support/read.ts';

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
    const display = { count: 0 };
    const shown = { count: 0, last: 0 };
    keepState(world, display, shown);
    world.phases.events.push((_, dt) => {
      if (Math.floor((world.time + dt) * rate + 1e-6) === display.count) return;
      display.count++;
      // The rule of a game that saves pictures: draw only if 1/cap has passed since the last one that was drawn.
      const time = display.count / rate;
      if (time - shown.last < 1 / cap - 1e-9) return;
      shown.last = time;
      shown.count++;
    });
    return { world, dt: 1 / 720, shown, x: () => placeAfter(shown.count) };
  },
  picture: ({ world, shown, x }) =>
    discOnLine(x, COLORS.green, () => `${shown.count} pictures in ${world.time.toFixed(1)} s`),
  plots: (plot) => [
    plot('Pictures so far', 'pictures', {
      label: 'shown',
      value: ({ shown }) => shown.count,
      exact: (t, { cap }) => cap * t,
    }),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Pictures in 10 s: every ⌈rate/cap⌉-th of the display’s',
      { exact: ({ rate, cap }) => Math.floor((10 * rate) / Math.ceil(rate / cap)), absolute: 0 },
      ({ shown }) => shown.count,
    ),
    at(
      10,
      'Pictures in 10 s of a display of 144 with a cap of 60',
      { exact: 480, absolute: 0 },
      ({ shown }) => shown.count,
    ),
  ],
  tryThis: ['Raise the cap until it is 72, half of 144: now every second picture is shown, and none is lost.'],
});
