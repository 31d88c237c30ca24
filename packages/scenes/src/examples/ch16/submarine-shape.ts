import { cos, keepState, sin } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point, pointsOf } from '../picture.ts';
import { FIGURE_CHECKS, spinFigure } from '../support/figure.ts';
import { held } from '../support/held.ts';

const HALF = 0.8;
const end = (side: number): Point[] =>
  pointsOf(
    (angle) => ({ x: side * (1.8 + HALF * cos(angle)), y: side * HALF * sin(angle) }),
    -Math.PI / 2,
    Math.PI / 2,
    10,
  );
const TOWER = [
  { x: 0.6, y: HALF },
  { x: 0.5, y: 1.5 },
  { x: -0.5, y: 1.5 },
  { x: -0.6, y: HALF },
];
const HULL = [...end(1), ...TOWER, ...end(-1)];
/** The ballast tank: half as long and half as high as the hull. */
const TANK = { width: 2.6, height: 0.8, bottom: -0.7 };
const PORTHOLES = [-1.7, -1.02, -0.34, 0.34, 1.02, 1.7].map((x) => ({ x, y: 0.38 }));

export default defineExample({
  id: 'ch16-submarine-shape',
  title: 'A submarine to look at',
  chapter: 16,
  tags: ['drawing', 'submarine', 'components'],
  about:
    'A hull with round ends, a tower, six portholes, and the ballast tank that makes it dive: the water in it stands as high as it is full. Fill and empty it with F and E, or the buttons. The outline is a body, cut into convex pieces.',
  duration: 5,
  parameters: {
    fill: { label: 'Fraction of the tank that is full', initial: 0.5, min: 0, max: 1 },
    spin: { label: 'Angular velocity', unit: 'rad/s', initial: 0, min: -1, max: 1 },
  },
  actions: {
    fill: held('Fill', 'f', 'let water in', change, 0.3),
    empty: held('Empty', 'e', 'press water out', change, -0.3),
  },
  build({ fill, spin }: ValuesOf<'fill' | 'spin'>) {
    const figure = spinFigure(HULL, spin);
    const tank = { fill, change: 0 };
    keepState(figure.world, tank);
    figure.world.phases.input.push((_, dt) => {
      tank.fill = Math.min(1, Math.max(0, tank.fill + tank.change * dt));
    });
    return { ...figure, tank, level: () => TANK.height * tank.fill };
  },
  picture({ at, lines, level }) {
    const [half, { bottom, height }] = [TANK.width / 2, TANK];
    const corners = [bottom, bottom + height].flatMap((y) => [
      { x: -half, y },
      { x: half, y },
    ]);
    const water = Array.from({ length: 9 }, (_, i) => {
      const y = () => bottom + (level() * i) / 8;
      const color = COLORS.water;
      return { from: () => at({ x: -half, y: y() })(), to: () => at({ x: half, y: y() })(), color, width: 5 };
    });
    return {
      view: { minX: -3.6, maxX: 3.6, minY: -2.8, maxY: 2.8 },
      lines: [
        ...water,
        ...lines([corners[0], corners[1], corners[3], corners[2]], COLORS.grey, 2),
        ...lines(HULL, COLORS.white),
      ],
      dots: PORTHOLES.map((porthole) => ({ at: at(porthole), radius: 7, color: COLORS.yellow })),
    };
  },
  plots: (plot) => [plot('Water in the tank', 'height, m', { label: 'height', value: ({ level }) => level() })],
  checks: ({ at }) => [
    at(
      0,
      'Height of the water, fraction times height of the tank',
      { exact: ({ fill }) => fill * TANK.height, unit: 'm', absolute: 1e-12 },
      ({ level }) => level(),
    ),
    ...FIGURE_CHECKS,
  ],
  tryThis: ['Let it turn: the water is painted, and turns along. In the example “Submarine” it has weight.'],
});

function change({ tank }: { readonly tank: { change: number } }, rate: number): void {
  tank.change = rate;
}
