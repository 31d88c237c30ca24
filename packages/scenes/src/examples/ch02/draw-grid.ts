import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Line } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

const AREA = { minX: 50, maxX: 400, minY: 50, maxY: 300 };

/** The places of lines from one edge to the other. */
const places = (from: number, to: number, step: number) =>
  Array.from({ length: Math.floor((to - from) / step + 1e-9) + 1 }, (_, i) => from + i * step);

export default defineExample({
  id: 'ch02-draw-grid',
  title: 'Graph paper',
  chapter: 2,
  tags: ['drawing', 'coordinates'],
  about:
    'A grid is drawn by two loops, one for the upright lines and one for the level ones. Mind the ends: a range of 350 px in steps of 10 px has 35 gaps, and 36 lines. It is the same with fence posts.',
  duration: 2,
  parameters: { distance: { label: 'Distance of the lines', unit: 'px', initial: 10, min: 5, max: 50 } },
  presets: [{ label: 'Coarse', values: { distance: 50 } }],
  build({ distance }: ValuesOf<'distance'>) {
    const upright = places(AREA.minX, AREA.maxX, distance);
    const level = places(AREA.minY, AREA.maxY, distance);
    return { world: emptyWorld(), dt: 1 / 60, upright, level };
  },
  picture({ upright, level }) {
    const style = { color: COLORS.blue, width: 1 };
    const lines: Line[] = [
      ...upright.map((x) => ({ from: { x, y: AREA.minY }, to: { x, y: AREA.maxY }, ...style })),
      ...level.map((y) => ({ from: { x: AREA.minX, y }, to: { x: AREA.maxX, y }, ...style })),
    ];
    return {
      yDown: true,
      view: { minX: 0, maxX: 450, minY: 20, maxY: 350 },
      lines,
      labels: [{ at: { x: 60, y: 335 }, text: `${upright.length} upright and ${level.length} level lines` }],
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(0, 'Upright lines, 350/10 + 1', { exact: 36, absolute: 0 }, ({ upright }) => upright.length),
    at(0, 'Level lines, 250/10 + 1', { exact: 26, absolute: 0 }, ({ level }) => level.length),
  ],
  tryThis: ['Choose a distance that does not divide 350: the last gap is missing, and the grid ends too soon.'],
});
