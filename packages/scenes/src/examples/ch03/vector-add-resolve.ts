import { atan2, cos, sin } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { emptyWorld, lengthOf } from '../support/read.ts';

const polar = (length: number, angle: number): Point => ({ x: length * cos(angle), y: length * sin(angle) });
const sum = (a: Point, b: Point): Point => ({ x: a.x + b.x, y: a.y + b.y });

export default defineExample({
  id: 'ch03-vector-add-resolve',
  title: 'Adding arrows',
  chapter: 3,
  tags: ['vectors'],
  about:
    'Two people pull at a box, each in a different direction. Put the tail of the second arrow to the tip of the first, and you get the arrow of what both do together. It is the diagonal of the parallelogram of both: never longer than the two arrows in a row, and never shorter than the difference of their lengths.',
  duration: 12,
  parameters: {
    a: { label: 'Length of a', initial: 3, min: 0.5, max: 5 },
    b: { label: 'Length of b', initial: 4, min: 0.5, max: 5 },
    angle: { label: 'Angle between them at first', unit: '°', initial: 90, min: 0, max: 180 },
    rate: { label: 'Turning of b', unit: '°/s', initial: 30, min: 0, max: 90 },
  },
  build({ a, b, angle, rate }: ValuesOf<'a' | 'b' | 'angle' | 'rate'>) {
    const world = emptyWorld();
    const first = polar(a, 0);
    const second = () => polar(b, ((angle + rate * world.time) * Math.PI) / 180);
    return { world, dt: 1 / 60, first, second, total: () => sum(first, second()) };
  },
  picture({ first, second, total }) {
    const origin = { x: 0, y: 0 };
    return {
      view: { minX: -6, maxX: 10, minY: -5.5, maxY: 5.5 },
      lines: [
        { from: () => second(), to: () => total(), color: COLORS.blue, width: 1 },
        { from: first, to: () => total(), color: COLORS.orange, width: 1 },
        { from: () => ({ x: total().x, y: 0 }), to: () => total(), color: COLORS.ground },
        { from: { x: -6, y: 0 }, to: { x: 10, y: 0 }, color: COLORS.ground },
      ],
      arrows: [
        { label: 'a', from: origin, vector: () => first, color: COLORS.blue },
        { label: 'b', from: origin, vector: second, color: COLORS.orange },
        { label: 'a + b', from: origin, vector: total, color: COLORS.green },
      ],
      labels: [{ at: { x: -5.8, y: 4.8 }, text: () => `length of a + b: ${lengthOf(total()).toFixed(2)}` }],
    };
  },
  plots: (plot) => [
    plot('Length of a + b, √(a² + b² + 2 a b cos α)', 'length', {
      label: 'length',
      value: ({ total }) => lengthOf(total()),
      exact: (t, { a, b, angle, rate }) =>
        Math.sqrt(a * a + b * b + 2 * a * b * cos(((angle + rate * t) * Math.PI) / 180)),
    }),
  ],
  checks: ({ at }) => [
    at(0, 'Length of 3 and 4 at a right angle', { exact: 5, absolute: 1e-12 }, ({ total }) => lengthOf(total())),
    at(
      0,
      'Direction of their sum',
      { exact: (atan2(4, 3) * 180) / Math.PI, unit: '°', absolute: 1e-12 },
      ({ total }) => (atan2(total().y, total().x) * 180) / Math.PI,
    ),
    at(
      0,
      'Resolved into length and angle and put together again: largest change',
      { exact: 0, absolute: 1e-15 },
      () => {
        const again = polar(lengthOf({ x: 0.6, y: 0.8 }), atan2(0.8, 0.6));
        return Math.max(Math.abs(again.x - 0.6), Math.abs(again.y - 0.8));
      },
    ),
  ],
  tryThis: [
    'Stop the turning and set the angle to 180°: now the arrows pull against each other, and 1 is left.',
    'Make both equally long: at an angle of 120° the sum is as long as each of them.',
  ],
});
