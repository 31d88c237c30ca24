import { exp, sin } from '@principia/physics';
import { choiceOf, defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { graphOf, largestOf, type RealFunction } from '../support/functions.ts';
import { emptyWorld } from '../support/read.ts';

const sine: RealFunction = (x) => sin((x * Math.PI) / 180);
const damped: RealFunction = (x) => exp(-0.002 * x) * sine(x);
const beats: RealFunction = (x) => sine(x) + sine(1.5 * x);
const CHOICES: readonly { readonly name: string; readonly f: RealFunction; readonly top: number }[] = [
  { name: 'Beats: sin x + sin 1.5x', f: beats, top: 2 },
  { name: 'Closer beats: sin 3x + sin 3.5x', f: (x) => sine(3 * x) + sine(3.5 * x), top: 2 },
  { name: 'A wave that dies away', f: damped, top: 1 },
  { name: 'A tone with overtones', f: (x) => sine(x) + sine(2 * x) / 2 + sine(3 * x) / 3, top: 2 },
];

const DEGREES_PER_SECOND = 432;

export default defineExample({
  id: 'ch03-wave-mix',
  title: 'Mixing waves',
  chapter: 3,
  tags: ['functions', 'waves', 'sound'],
  about:
    'Two tones of nearly the same pitch swell and fade: where both waves go up together they double, and where one goes up and the other down they cancel. Piano tuners listen to these beats. Tones with overtones make the difference between a flute and a violin.',
  duration: 1440 / DEGREES_PER_SECOND,
  ends: true,
  parameters: {
    wave: choiceOf(
      'Wave',
      CHOICES.map(({ name }) => name),
    ),
  },
  presets: CHOICES.slice(1).map(({ name }, i) => ({ label: name, values: { wave: i + 1 } })),
  build: () => ({ world: emptyWorld(), dt: 1 / 60 }),
  picture({ world }, { wave }) {
    const { name, f, top } = CHOICES[wave];
    const x = () => DEGREES_PER_SECOND * world.time;
    return {
      graph: { x: { label: 'x, degrees', step: 180 }, y: { label: 'y', step: 0.5 } },
      view: { minX: 0, maxX: 1440, minY: -1.15 * top, maxY: 1.15 * top },
      curves: [{ points: graphOf(f, 0, 1440, 1440), color: COLORS.blue }],
      dots: [
        { at: () => ({ x: x(), y: f(x()) }), color: COLORS.orange },
        { at: () => ({ x: 1440, y: f(x()) }), color: COLORS.orange },
      ],
      labels: [{ at: { x: 30, y: 1.03 * top }, text: name, color: COLORS.blue }],
    };
  },
  plots: [],
  checks: ({ at }) => [
    // sin a + sin b = 2 sin((a + b)/2) cos((a − b)/2).
    at(0, 'Largest difference of the beats and 2 sin 1.25x cos 0.25x', { exact: 0, absolute: 1e-12 }, () =>
      largestOf((x) => beats(x) - 2 * sine(1.25 * x) * sine(0.25 * x + 90), 0, 1440),
    ),
    at(0, 'The wave that dies away at 450°, exp(−0.9)', { exact: 0.4065697, absolute: 1e-6 }, () => damped(450)),
  ],
  tryThis: [
    'Look for the places where the beats are silent: at 360° and again 720° later.',
    'Choose the closer beats: the tones are higher, but the silences lie where they were.',
  ],
});
