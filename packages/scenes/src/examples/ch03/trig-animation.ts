import { sin } from '@principia/physics';
import { defineExample } from '../define-example.ts';
import { COLORS, pointsOf } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

/** Partial sum of the Fourier series of a square wave: sin x + sin 3x/3 + …, x in degrees. */
function squareWave(degrees: number, terms: number): number {
  let sum = 0;
  for (let n = 1; n < 2 * terms; n += 2) sum += sin((n * degrees * Math.PI) / 180) / n;
  return sum;
}

/** The dot moves by 7.2° in each of 60 ticks a second. */
const DEGREES_PER_SECOND = 432;

export default defineExample({
  id: 'ch03-trig-animation',
  title: 'A square wave from sines',
  chapter: 3,
  tags: ['functions', 'waves', 'fourier'],
  about:
    'The sines of x, 3x, 5x and so on, each divided by its number, add up to a wave that comes closer and closer to a square. Near its edges it overshoots: by nine per cent of the jump however many sines are added, as Gibbs explained.',
  duration: 1440 / DEGREES_PER_SECOND,
  ends: true,
  parameters: {
    terms: { label: 'Number of sines', initial: 5, min: 1, max: 1000, integer: true, scale: 'log' },
  },
  presets: [
    { label: 'One sine', values: { terms: 1 } },
    { label: 'Fifty sines', values: { terms: 50 } },
  ],
  build: () => ({ world: emptyWorld(), dt: 1 / 60 }),
  picture({ world }, { terms }) {
    const at = () => {
      const x = Math.min(1440, DEGREES_PER_SECOND * world.time);
      return { x, y: squareWave(x, terms) };
    };
    return {
      graph: { x: { label: 'x, degrees', step: 180 }, y: { label: 'sum' } },
      view: { minX: 0, maxX: 1440, minY: -1.2, maxY: 1.2 },
      curves: [
        {
          points: pointsOf((x) => ({ x, y: squareWave(x, terms) }), 0, 1440, 1600),
          label: `${terms} sines`,
          color: COLORS.blue,
        },
      ],
      lines: [Math.PI / 4, -Math.PI / 4].map((y) => ({
        from: { x: 0, y },
        to: { x: 1440, y },
        color: COLORS.grey,
        width: 1,
      })),
      dots: [
        { at, color: COLORS.orange },
        { at: () => ({ x: 1440, y: at().y }), color: COLORS.orange },
      ],
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(0, 'Sum at 90°', { exact: 1 - 1 / 3 + 1 / 5 - 1 / 7 + 1 / 9, absolute: 1e-6 }, () => squareWave(90, 5)),
    at(0, 'Half of the Gibbs peak of many sines, Si(π)/2', { exact: 0.925968526, absolute: 1e-6 }, () =>
      squareWave(180 / 4000, 2000),
    ),
    at(
      0,
      'Limit at 90° of many sines, π/4: the mean of the sums of 1000 and 1001',
      { exact: Math.PI / 4, absolute: 1e-6 },
      () => (squareWave(90, 1000) + squareWave(90, 1001)) / 2,
    ),
  ],
  tryThis: [
    'Add sines one by one: the edges become steeper and the ripples narrower, but the first ripple keeps its height.',
    'With a single sine you see the wave that all others are added to.',
  ],
});
