import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Fill, type Point } from '../picture.ts';
import { distanceBetween, emptyWorld } from '../support/read.ts';

const FROM = { x: 50, y: 100 };

/** The squares that a line goes through if it takes one in each row or column (Bresenham 1965). */
function squaresOf(a: Point, b: Point, side: number): Point[] {
  const [dx, dy] = [(b.x - a.x) / side, (b.y - a.y) / side];
  const count = Math.max(Math.abs(dx), Math.abs(dy), 1);
  return Array.from({ length: Math.round(count) + 1 }, (_, i) => ({
    x: a.x + side * Math.round((dx * i) / count),
    y: a.y + side * Math.round((dy * i) / count),
  }));
}

export default defineExample({
  id: 'ch02-draw-lines',
  title: 'A line of little squares',
  chapter: 2,
  tags: ['drawing', 'geometry'],
  about:
    'A screen is made of little squares, so it cannot draw a slanting line: it lights the squares that are nearest to it, one in each row. Make the squares smaller and the steps vanish. The length of the line, which Pythagoras tells, is more than the number of its squares.',
  duration: 2,
  parameters: {
    x: { label: 'End, x', unit: 'px', initial: 250, min: 50, max: 650 },
    y: { label: 'End, y', unit: 'px', initial: 400, min: 0, max: 480 },
    side: { label: 'Side of a square', unit: 'px', initial: 10, min: 4, max: 50, integer: true },
  },
  build({ x, y, side }: ValuesOf<'x' | 'y' | 'side'>) {
    const squares = squaresOf(FROM, { x, y }, side);
    return { world: emptyWorld(), dt: 1 / 60, squares, length: () => distanceBetween(FROM, { x, y }) };
  },
  picture({ squares, length }, { x, y, side }) {
    const half = side / 2;
    const fills = squares.map((at): Fill => {
      const shape = { minX: at.x - half, maxX: at.x + half, minY: at.y - half, maxY: at.y + half };
      return { shape, color: COLORS.blue, opacity: 0.55 };
    });
    return {
      yDown: true,
      view: { minX: 0, maxX: 700, minY: 0, maxY: 500 },
      fills,
      lines: [{ from: FROM, to: { x, y }, color: COLORS.white }],
      labels: [{ at: { x: 330, y: 60 }, text: `${length().toFixed(1)} px long, ${squares.length} squares` }],
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(
      0,
      'Length, √(200² + 300²)',
      { exact: Math.sqrt(200 * 200 + 300 * 300), unit: 'px', absolute: 1e-9 },
      ({ length }) => length(),
    ),
    at(0, 'Squares of 10 px, one in each row: 300/10 + 1', { exact: 31, absolute: 0 }, ({ squares }) => squares.length),
  ],
  tryThis: [
    'Make the squares small: the steps are still there, only too small to see.',
    'Make the line almost level: now it takes one square in each column.',
  ],
});
