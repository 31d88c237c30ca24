import { choiceOf, defineExample } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { graphOf, type RealFunction, rootOf, slopeOf } from '../support/functions.ts';
import { emptyWorld } from '../support/read.ts';

const quadratic: RealFunction = (x) => x * x - 2 * x - 3;
const cubic: RealFunction = (x) => x * x * x + x * x - 2 * x - 3;
const quintic: RealFunction = (x) => -0.5 * x * x * x * x * x + 3 * x * x * x + x * x - 2 * x - 3;
const FUNCTIONS = [quadratic, cubic, quintic];
const NAMES = ['x² − 2x − 3', 'x³ + x² − 2x − 3', '−½x⁵ + 3x³ + x² − 2x − 3'];

export default defineExample({
  id: 'ch03-polynomials',
  title: 'Curves with valleys and hills',
  chapter: 3,
  tags: ['functions', 'graph', 'roots'],
  about:
    'A polynomial is a sum of powers of x. With x² the curve has one valley, with x³ a hill and a valley, and with x⁵ it may have two of each. The short line is the tangent at the dot: it is level at the bottom of a valley and on top of a hill.',
  duration: 10,
  parameters: {
    curve: choiceOf('Function', NAMES),
  },
  presets: NAMES.slice(1).map((label, i) => ({ label, values: { curve: i + 1 } })),
  build: () => ({ world: emptyWorld(), dt: 1 / 60 }),
  picture({ world }, { curve }) {
    const [f, edge] = [FUNCTIONS[curve], curve === 0 ? 4 : 2.6];
    // The dot goes to and fro over the whole graph.
    const x = () => edge * (1 - Math.abs(((world.time / 5) % 2) - 1) * 2);
    const tangent = (side: number) => () => {
      const m = slopeOf(f, x());
      const reach = (side * 0.15 * edge) / Math.sqrt(1 + (m * m) / 16);
      return { x: x() + reach, y: f(x()) + m * reach };
    };
    return {
      graph: { x: { label: 'x', step: 1 }, y: { label: 'y', step: 5 } },
      view: { minX: -edge, maxX: edge, minY: -12, maxY: 22 },
      curves: [{ points: graphOf(f, -edge, edge).filter(({ y }) => y > -12 && y < 22), color: COLORS.blue }],
      lines: [{ from: tangent(-1), to: tangent(1), color: COLORS.green, width: 3 }],
      dots: [{ at: () => ({ x: x(), y: f(x()) }) }],
      labels: [{ at: { x: -0.9 * edge, y: 19 }, text: `y = ${NAMES[curve]}`, color: COLORS.blue }],
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(0, 'Left zero of x² − 2x − 3', { exact: -1, absolute: 1e-10 }, () => rootOf(quadratic, -3, 0)),
    at(0, 'Right zero', { exact: 3, absolute: 1e-10 }, () => rootOf(quadratic, 0, 5)),
    at(0, 'Place of the lowest point, where the slope is 0', { exact: 1, absolute: 1e-10 }, () =>
      rootOf((x) => slopeOf(quadratic, x), -3, 5),
    ),
    at(0, 'Value at the lowest point', { exact: -4, absolute: 1e-10 }, () =>
      quadratic(rootOf((x) => slopeOf(quadratic, x), -3, 5)),
    ),
  ],
  tryThis: [
    'Count the places where the tangent is level: one with x², two with x³, four with x⁵.',
    'Look at the far ends: an odd highest power ends up on one side and down on the other.',
  ],
});
