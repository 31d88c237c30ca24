import { rgba, spawn } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Fill, type Point } from '../picture.ts';
import { emptyWorld } from '../support/read.ts';

const MIDDLE = { x: 100, y: 100 };

/** The squares of a grid whose middle is in a disc. */
function squaresIn(radius: number, side: number): Point[] {
  const squares: Point[] = [];
  const count = Math.ceil(radius / side);
  for (let i = -count; i < count; i++) {
    for (let j = -count; j < count; j++) {
      const [x, y] = [side * (i + 0.5), side * (j + 0.5)];
      if (x * x + y * y <= radius * radius) squares.push({ x: MIDDLE.x + x, y: MIDDLE.y + y });
    }
  }
  return squares;
}

export default defineExample({
  id: 'ch02-ball-object',
  title: 'A ball of little squares',
  chapter: 2,
  tags: ['drawing', 'geometry', 'components'],
  about:
    'Our ball knows where it is, how large it is and which colour it has; drawing it is somebody else’s work. The screen fills the squares whose middle is in the disc. Count them, and you have measured π: the area of the squares is π r², more exactly the smaller they are.',
  duration: 2,
  parameters: {
    radius: { label: 'Radius', unit: 'px', initial: 50, min: 10, max: 80 },
    side: { label: 'Side of a square', unit: 'px', initial: 5, min: 4, max: 20 },
  },
  build({ radius, side }: ValuesOf<'radius' | 'side'>) {
    const world = emptyWorld();
    spawn(world, { position: MIDDLE, collider: radius, appearance: rgba(0.43, 0.72, 1, 0.6) });
    return {
      world,
      dt: 1 / 60,
      squares: squaresIn(radius, side),
      area: (fine: number) => squaresIn(radius, fine).length * fine * fine,
    };
  },
  picture({ squares }, { side, radius }) {
    const half = 0.46 * side;
    return {
      yDown: true,
      view: { minX: 0, maxX: 330, minY: 0, maxY: 200 },
      fills: squares.map(({ x, y }): Fill => {
        return { shape: { minX: x - half, maxX: x + half, minY: y - half, maxY: y + half }, color: COLORS.orange };
      }),
      labels: [
        { at: { x: 205, y: 80 }, text: `${squares.length} squares` },
        { at: { x: 205, y: 100 }, text: `π ≈ ${((squares.length * side * side) / (radius * radius)).toFixed(3)}` },
      ],
    };
  },
  plots: [],
  checks: ({ at }) => [
    at(0, 'Area in squares of 1 px, π r²', { exact: 7854, unit: 'px²', relative: 0.01 }, ({ area }) => area(1)),
  ],
  tryThis: ['Take large squares and change the radius a little: the number of squares jumps, and π with it.'],
});
