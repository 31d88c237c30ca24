import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS } from '../picture.ts';
import { FIGURE_CHECKS, spinFigure } from '../support/figure.ts';

const HULL = [
  { x: 0, y: 2.4 },
  { x: 0.55, y: 1.3 },
  { x: 0.55, y: -0.9 },
  { x: 1.2, y: -1.7 },
  { x: 1.2, y: -2.1 },
  { x: -1.2, y: -2.1 },
  { x: -1.2, y: -1.7 },
  { x: -0.55, y: -0.9 },
  { x: -0.55, y: 1.3 },
];
const WINDOW = { x: 0, y: 0.9 };

export default defineExample({
  id: 'ch06-rocket-shape',
  title: 'A rocket to look at',
  chapter: 6,
  tags: ['drawing', 'rocket', 'components'],
  about:
    'Nine corners make a rocket, three more its flame, which is there only while the engine burns. The drawing is a body as well: cut into convex pieces it has an area, a mass and a centre of mass, and it turns about that. Press F, or the button, to burn.',
  duration: 5,
  parameters: { spin: { label: 'Angular velocity', unit: 'rad/s', initial: 0.5, min: -3, max: 3 } },
  actions: {
    fire: {
      label: 'Fire',
      about: 'burn the engine',
      key: 'f',
      press: ({ engine }) => {
        engine.burns = true;
      },
      release: ({ engine }) => {
        engine.burns = false;
      },
    },
  },
  build: ({ spin }: ValuesOf<'spin'>) => ({ ...spinFigure(HULL, spin), engine: { burns: false } }),
  picture({ world, at, lines, engine }) {
    // It flickers, and shrinks into the nozzle when the engine stops.
    const length = () => (engine.burns ? 1.1 + 0.25 * ((world.tick % 7) / 7) : 0);
    const flame = (x: number) => () => at({ x, y: -2.1 })();
    const tip = () => at({ x: 0, y: -2.1 - length() })();
    const colour = COLORS.yellow;
    return {
      view: { minX: -4.5, maxX: 4.5, minY: -3.8, maxY: 3.8 },
      lines: [
        ...lines(HULL, COLORS.white),
        { from: flame(-0.4), to: tip, color: colour },
        { from: flame(0.4), to: tip, color: colour },
        { from: flame(0), to: tip, color: COLORS.orange },
      ],
      dots: [
        { at: at(WINDOW), radius: 9, color: COLORS.blue },
        { at: { x: 0, y: 0 }, radius: 4, color: COLORS.red },
      ],
    };
  },
  plots: [],
  checks: FIGURE_CHECKS,
  tryThis: ['Look at the red dot, the centre of mass: it lies low, where the fins are.'],
});
