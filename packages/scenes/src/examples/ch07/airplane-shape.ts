import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { FIGURE_CHECKS, spinFigure } from '../support/figure.ts';

const OUTLINE = [
  { x: 2.9, y: 0 },
  { x: 2.5, y: 0.35 },
  { x: 1.7, y: 0.5 },
  { x: 1.3, y: 0.85 },
  { x: 0.5, y: 0.85 },
  { x: 0.2, y: 0.5 },
  { x: -1.9, y: 0.35 },
  { x: -2.5, y: 1.2 },
  { x: -2.9, y: 1.2 },
  { x: -2.7, y: 0.1 },
  { x: -1.6, y: -0.35 },
  { x: 2.3, y: -0.4 },
];
const WING = [
  { x: 0.6, y: -0.1 },
  { x: -0.9, y: -0.65 },
  { x: -1.3, y: -0.65 },
  { x: -0.5, y: -0.1 },
];
const PORTHOLES = [-1, -0.5, 0].map((x) => ({ x, y: 0.2 }));

export default defineExample({
  id: 'ch07-airplane-shape',
  title: 'An aeroplane to look at',
  chapter: 7,
  tags: ['drawing', 'flight', 'components'],
  about:
    'A fuselage, a cockpit and a tail in one outline, a wing in front of it, and three windows. The outline is concave, so the engine cuts it into convex pieces that touch without gaps: together they weigh what the area says, and turn about the same centre of mass.',
  duration: 5,
  parameters: { spin: { label: 'Angular velocity', unit: 'rad/s', initial: 0.3, min: -3, max: 3 } },
  build: ({ spin }: ValuesOf<'spin'>) => spinFigure(OUTLINE, spin),
  picture: ({ at, lines }) => ({
    view: { minX: -4, maxX: 4, minY: -3.3, maxY: 3.3 },
    lines: [...lines(OUTLINE, COLORS.white), ...lines(WING, COLORS.blue)],
    dots: [
      ...PORTHOLES.map((porthole) => ({ at: at(porthole), radius: 6, color: COLORS.yellow })),
      { at: { x: 0, y: 0 }, radius: 4, color: COLORS.red },
    ],
  }),
  plots: [],
  checks: FIGURE_CHECKS,
  tryThis: ['Switch the code on and move the tail farther back: the red centre of mass follows a little.'],
});
