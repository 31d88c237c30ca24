import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

const START = 50;
const WIDTH = 650;
/** Where a dot comes in again at the left after it has crossed the stage. */
const onStage = (x: number) => START + ((x - START) % WIDTH);

export default defineExample({
  id: 'ch02-elapsed-time',
  title: 'Fast and slow screens',
  chapter: 2,
  tags: ['time', 'frame rate', 'uniform motion'],
  about:
    'Three screens show 30, 60 and 144 pictures a second. The orange dots take a step of 2 px from each picture to the next, so the best screen shows the fastest dot. The blue dots move by their velocity, 200 px/s, times the time that has passed since the last picture: all three arrive together, and only move more or less smoothly.',
  duration: 10,
  parameters: {
    speed: { label: 'Velocity', unit: 'px/s', initial: 200, min: 0, max: 400 },
    perFrame: { label: 'Step per picture', unit: 'px', initial: 2, min: 0, max: 4 },
  },
  build({ speed, perFrame }: ValuesOf<'speed' | 'perFrame'>) {
    const world = emptyWorld();
    const screens = [30, 60, 144].map((rate, i) => {
      // A picture is due at each full multiple of its duration; the tolerance is for sums of steps.
      const frames = () => Math.floor(world.time * rate + 1e-6);
      return {
        rate,
        y: 110 + 130 * i,
        timed: () => START + (speed * frames()) / rate,
        counted: () => START + perFrame * frames(),
      };
    });
    return { world, dt: 1 / 720, screens };
  },
  picture: ({ screens }) => ({
    yDown: true,
    view: { minX: 0, maxX: 750, minY: 30, maxY: 460 },
    lines: screens.map(({ y }) => ({ from: { x: 0, y: y + 65 }, to: { x: 750, y: y + 65 }, color: COLORS.ground })),
    labels: screens.map(({ rate, y }) => ({ at: { x: 10, y: y - 32 }, text: `${rate} pictures a second` })),
    dots: screens.flatMap(({ y, timed, counted }) => [
      { at: () => ({ x: onStage(timed()), y: y - 10 }), radius: 12, color: COLORS.blue },
      { at: () => ({ x: onStage(counted()), y: y + 30 }), radius: 12, color: COLORS.orange },
    ]),
  }),
  plots: (plot) => [
    plot(
      'Distance by counting pictures',
      'distance, px',
      ...[30, 60, 144].map((rate, i) => ({
        label: `${rate} a second`,
        value: ({ screens }: { screens: readonly { counted(): number }[] }) => screens[i].counted() - START,
      })),
    ),
  ],
  checks: ({ at }) => [
    at(
      10,
      'Distance of a blue dot in 10 s, v t',
      { exact: ({ speed }) => 10 * speed, unit: 'px', relative: 1e-9 },
      ({ screens }) => screens[2].timed() - START,
    ),
    at(10, 'Largest distance of two blue dots after 10 s', { exact: 0, unit: 'px', absolute: 1e-9 }, ({ screens }) =>
      Math.max(...screens.map((a) => Math.abs(a.timed() - screens[0].timed()))),
    ),
    at(
      10,
      'Orange dot at 60 pictures a second after n = 600 of them, 2 n',
      { exact: ({ perFrame }) => 600 * perFrame, unit: 'px', absolute: 1e-9 },
      ({ screens }) => screens[1].counted() - START,
    ),
    at(
      10,
      'Orange dots: fastest and slowest, 144/30',
      { exact: 4.8, relative: 1e-9 },
      ({ screens }) => (screens[2].counted() - START) / (screens[0].counted() - START),
    ),
  ],
  tryThis: [
    'Set the velocity to 120 px/s: now the middle row moves at the same speed in both ways, and the others do not.',
    'Look closely at the blue dot of the first row: it goes in larger, rarer jumps, but is never late.',
  ],
});
