import { cos, sin } from '@principia/physics';
import { choiceOf, defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { graphOf, largestOf, type RealFunction } from '../support/functions.ts';
import { emptyWorld } from '../support/read.ts';

const rad = (degrees: number) => (degrees * Math.PI) / 180;
const sine: RealFunction = (x) => sin(rad(x));
const cosine: RealFunction = (x) => cos(rad(x));
const tangent: RealFunction = (x) => sine(x) / cosine(x);
const shifted: RealFunction = (x) => cosine(x - 90);
const CHOICES: readonly { readonly name: string; readonly f: RealFunction; readonly top: number }[] = [
  { name: 'sin x', f: sine, top: 1.5 },
  { name: 'cos x', f: cosine, top: 1.5 },
  { name: 'cos (x − 90°)', f: shifted, top: 1.5 },
  { name: 'tan x', f: tangent, top: 10 },
];

/** Pieces of a graph that stay below a height: the tangent runs out of the picture at each odd multiple of 90°. */
function piecesOf(f: RealFunction, top: number) {
  const branches = [-630, -450, -270, -90, 90, 270, 450, 630];
  return [-720, ...branches]
    .map((from, i) => graphOf(f, from, branches[i] ?? 720, 180).filter(({ y }) => Math.abs(y) <= top))
    .map((points) => ({ points, color: COLORS.blue }));
}

export default defineExample({
  id: 'ch03-trig-functions',
  title: 'Sine, cosine, tangent',
  chapter: 3,
  tags: ['functions', 'sine', 'waves'],
  about:
    'A point that goes round a circle is up, down and up again: its height is the sine of the angle, and its distance to the right the cosine. Both are the same wave, one 90° behind the other. Their quotient is the tangent, the steepness of the line to the point, which is infinite when the line stands upright.',
  duration: 12,
  parameters: {
    curve: choiceOf(
      'Function',
      CHOICES.map(({ name }) => name),
    ),
    rate: { label: 'Angle per second', unit: '°/s', initial: 60, min: 10, max: 180 },
  },
  presets: CHOICES.slice(1).map(({ name }, i) => ({ label: name, values: { curve: i + 1 } })),
  build: () => ({ world: emptyWorld(), dt: 1 / 60 }),
  picture({ world }, { curve, rate }) {
    const { name, f, top } = CHOICES[curve];
    const x = () => ((rate * world.time) % 1440) - 720;
    const at = () => ({ x: x(), y: Math.max(-top, Math.min(top, f(x()))) });
    return {
      graph: { x: { label: 'x, degrees', step: 180 }, y: { label: 'y', step: top > 2 ? 2 : 0.5 } },
      view: { minX: -720, maxX: 720, minY: -top, maxY: top },
      curves: piecesOf(f, top),
      lines: [{ from: () => ({ x: x(), y: 0 }), to: at, color: COLORS.orange, width: 1 }],
      dots: [{ at }],
      labels: [{ at: { x: -690, y: 0.85 * top }, text: `y = ${name}`, color: COLORS.blue }],
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(0, 'Largest difference of cos (x − 90°) and sin x', { exact: 0, absolute: 1e-12 }, () =>
      largestOf((x) => shifted(x) - sine(x), -720, 720),
    ),
    at(0, 'Largest difference of sin (x + 360°) and sin x', { exact: 0, absolute: 1e-12 }, () =>
      largestOf((x) => sine(x + 360) - sine(x), -720, 360),
    ),
    at(0, 'Sine of 30°', { exact: 0.5, absolute: 1e-12 }, () => sine(30)),
    at(0, 'Tangent of 45°', { exact: 1, absolute: 1e-12 }, () => tangent(45)),
  ],
  tryThis: [
    'Choose cos (x − 90°), and then sin x: you will not see any difference.',
    'Choose tan x: it repeats already after 180°, because opposite points of the circle lie on the same line.',
  ],
});
