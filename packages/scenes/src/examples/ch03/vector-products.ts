import { atan2, cos, sin } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { emptyWorld, lengthOf } from '../support/read.ts';

const dot = (a: Point, b: Point) => a.x * b.x + a.y * b.y;
const cross = (a: Point, b: Point) => a.x * b.y - a.y * b.x;

export default defineExample({
  id: 'ch03-vector-products',
  title: 'Two ways to multiply arrows',
  chapter: 3,
  tags: ['vectors', 'angles'],
  about:
    'The dot product says how far two arrows go in the same direction: it is the shadow of the one on the other, times the other’s length, and 0 at a right angle. The cross product says how far they spread: it is the area of the parallelogram, positive if the second lies to the left of the first, and 0 if they are in line.',
  duration: 12,
  parameters: {
    ax: { label: 'First arrow, x', initial: 1, min: -2, max: 2 },
    ay: { label: 'First arrow, y', initial: 1, min: -2, max: 2 },
    b: { label: 'Length of the second', initial: 1, min: 0.2, max: 2 },
    rate: { label: 'Turning of the second', unit: '°/s', initial: 30, min: 0, max: 90 },
  },
  build({ ax, ay, b, rate }: ValuesOf<'ax' | 'ay' | 'b' | 'rate'>) {
    const world = emptyWorld();
    const first = { x: ax, y: ay };
    const second = () => {
      const angle = (rate * world.time * Math.PI) / 180;
      return { x: b * cos(angle), y: b * sin(angle) };
    };
    return { world, dt: 1 / 60, first, second };
  },
  picture({ first, second }) {
    const origin = { x: 0, y: 0 };
    const tip = () => ({ x: first.x + second().x, y: first.y + second().y });
    // The foot of the perpendicular from the second arrow to the first.
    const shadow = () => {
      const share = dot(first, second()) / Math.max(1e-9, dot(first, first));
      return { x: share * first.x, y: share * first.y };
    };
    return {
      view: { minX: -2.6, maxX: 2.6, minY: -1.8, maxY: 2.2 },
      lines: [
        { from: first, to: tip, color: COLORS.ground },
        { from: second, to: tip, color: COLORS.ground },
        { from: second, to: shadow, color: COLORS.grey, width: 1 },
        { from: origin, to: shadow, color: COLORS.yellow, width: 6 },
      ],
      arrows: [
        { label: 'a', from: origin, vector: () => first, color: COLORS.blue },
        { label: 'b', from: origin, vector: second, color: COLORS.orange },
      ],
      labels: [
        { at: { x: -2.5, y: 1.95 }, text: () => `dot ${dot(first, second()).toFixed(2)}`, color: COLORS.yellow },
        { at: { x: -2.5, y: 1.7 }, text: () => `cross ${cross(first, second()).toFixed(2)}`, color: COLORS.grey },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Both products',
      'product',
      { label: 'dot', value: ({ first, second }) => dot(first, second()) },
      { label: 'cross', value: ({ first, second }) => cross(first, second()) },
    ),
  ],
  checks: ({ at }) => [
    at(0, 'Dot product of (1, 1) and (1, 0)', { exact: 1, absolute: 0 }, ({ first, second }) => dot(first, second())),
    at(0, 'Their cross product: the second lies to the right', { exact: -1, absolute: 0 }, ({ first, second }) =>
      cross(first, second()),
    ),
    at(0, 'Length of (1, 1)', { exact: Math.sqrt(2), absolute: 5e-7 }, ({ first }) => lengthOf(first)),
    at(0, 'Its dot product with itself, the square of the length', { exact: 2, absolute: 0 }, ({ first }) =>
      dot(first, first),
    ),
    at(
      0,
      'Angle between them',
      { exact: 45, unit: '°', absolute: 1e-12 },
      ({ first, second }) => (-atan2(cross(first, second()), dot(first, second())) * 180) / Math.PI,
    ),
  ],
  tryThis: [
    'Wait until the dot product is 0: the arrows are at a right angle, and the cross product is largest or smallest.',
    'Turn the first arrow round by giving both of its numbers the other sign: both products change their sign.',
  ],
});
