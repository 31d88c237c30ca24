import { exp, log } from '@principia/physics';
import { choiceOf, defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { areaOf, graphOf, type RealFunction, rootOf } from '../support/functions.ts';
import { emptyWorld } from '../support/read.ts';

interface Choice {
  readonly name: string;
  readonly f: RealFunction;
  readonly from: number;
  readonly to: number;
  readonly minY: number;
  readonly maxY: number;
}

const bell: RealFunction = (x) => exp(-x * x);
const decay: RealFunction = (x) => exp(-x);
const CHOICES: readonly Choice[] = [
  { name: 'Bell curve, exp(−x²)', f: bell, from: -3, to: 3, minY: 0, maxY: 1.1 },
  { name: 'Growth, exp(x)', f: exp, from: -3, to: 3, minY: 0, maxY: 21 },
  { name: 'Decay, exp(−x)', f: decay, from: 0, to: 6, minY: 0, maxY: 1.1 },
  { name: 'Logarithm, ln x', f: log, from: 0.02, to: 6, minY: -4, maxY: 2 },
];

export default defineExample({
  id: 'ch03-exponential-log',
  title: 'Growth, decay and the bell curve',
  chapter: 3,
  tags: ['functions', 'graph', 'exponential'],
  about:
    'Bacteria double in equal times, and coffee loses half of its extra warmth in equal times: exp(x) and exp(−x). The bell curve exp(−x²) shows up wherever many small accidents add up. The logarithm asks the reverse question: how long until it has grown so much?',
  duration: 6,
  parameters: {
    curve: choiceOf(
      'Function',
      CHOICES.map(({ name }) => name),
    ),
  },
  presets: CHOICES.slice(1).map(({ name }, i) => ({ label: name, values: { curve: i + 1 } })),
  build: () => ({ world: emptyWorld(), dt: 1 / 60 }),
  picture({ world }, { curve }) {
    const { name, f, from, to, minY, maxY } = CHOICES[curve];
    const x = () => from + ((to - from) * (world.time % 6)) / 6;
    return {
      graph: { x: { label: 'x', step: 1 }, y: { label: 'y' } },
      view: { minX: Math.floor(from), maxX: to, minY, maxY },
      fills:
        curve === 0
          ? [
              {
                shape: [...graphOf(f, from, to), { x: to, y: 0 }, { x: from, y: 0 }],
                color: COLORS.blue,
                opacity: 0.15,
              },
            ]
          : [],
      curves: [{ points: graphOf(f, from, to), color: COLORS.blue }],
      lines: [{ from: () => ({ x: x(), y: 0 }), to: () => ({ x: x(), y: f(x()) }), color: COLORS.orange, width: 1 }],
      dots: [{ at: () => ({ x: x(), y: f(x()) }) }],
      labels: [{ at: { x: Math.floor(from) + 0.2, y: maxY - 0.12 * (maxY - minY) }, text: name, color: COLORS.blue }],
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(0, 'Area under the bell curve, √π', { exact: Math.sqrt(Math.PI), absolute: 1e-3 }, () =>
      areaOf(bell, -3, 3, 100),
    ),
    at(0, 'Where exp(−x) has fallen to a half, ln 2', { exact: log(2), absolute: 1e-10 }, () =>
      rootOf((x) => decay(x) - 0.5, 0, 6),
    ),
    at(0, 'Largest difference of ln(exp(x)) and x', { exact: 0, absolute: 1e-12 }, () =>
      Math.max(...graphOf((x) => Math.abs(log(exp(x)) - x), -3, 3).map(({ y }) => y)),
    ),
  ],
  tryThis: [
    'Choose the decay: after 0.69 half is left, after 1.39 a quarter, after 2.08 an eighth.',
    'Choose the logarithm: it grows for ever, but ever more slowly, and dives without end at 0.',
  ],
});
