import { cos, sin } from '@principia/physics';
import { defineExample, type ValuesOf } from '../define-example.ts';
import { COLORS, type Point } from '../picture.ts';
import { emptyWorld, lengthOf } from '../support/read.ts';

const add = (a: Point, b: Point): Point => ({ x: a.x + b.x, y: a.y + b.y });
const subtract = (a: Point, b: Point): Point => ({ x: a.x - b.x, y: a.y - b.y });
const scale = (a: Point, factor: number): Point => ({ x: factor * a.x, y: factor * a.y });
const dot = (a: Point, b: Point): number => a.x * b.x + a.y * b.y;
const unit = (a: Point): Point => scale(a, 1 / lengthOf(a));

export default defineExample({
  id: 'ch03-vector-object',
  title: 'What one does with arrows',
  chapter: 3,
  tags: ['vectors', 'geometry'],
  about:
    'Two numbers that go together make a vector. Add two by putting the second at the tip of the first; subtract, and you get the arrow from one tip to the other. Divide a vector by its length and its direction is left, of length 1: the small white arrow. With these few operations all of our motion is written.',
  duration: 12,
  parameters: {
    a: { label: 'Length of the first', initial: 1.5, min: 0.2, max: 2 },
    b: { label: 'Length of the second', initial: 1, min: 0.2, max: 2 },
  },
  build({ a, b }: ValuesOf<'a' | 'b'>) {
    const world = emptyWorld();
    const turned = (length: number, rate: number) => ({
      x: length * cos(rate * world.time),
      y: length * sin(rate * world.time),
    });
    return { world, dt: 1 / 60, first: () => turned(a, 0.3), second: () => turned(b, -0.8) };
  },
  picture({ first, second }) {
    const origin = { x: 0, y: 0 };
    const sum = () => add(first(), second());
    return {
      view: { minX: -3, maxX: 3, minY: -2.4, maxY: 2.4 },
      lines: [
        { from: first, to: sum, color: COLORS.ground },
        { from: second, to: sum, color: COLORS.ground },
      ],
      arrows: [
        { label: 'a', from: origin, vector: first, color: COLORS.blue },
        { label: 'b', from: origin, vector: second, color: COLORS.orange },
        { label: 'a + b', from: origin, vector: sum, color: COLORS.green },
        { label: 'a − b', from: second, vector: () => subtract(first(), second()), color: COLORS.violet },
        { label: 'a/|a|', from: origin, vector: () => unit(first()), color: COLORS.white },
      ],
    };
  },
  plots: (plot) => [
    plot(
      'Lengths',
      'length',
      { label: 'of the sum', value: ({ first, second }) => lengthOf(add(first(), second())) },
      { label: 'of the difference', value: ({ first, second }) => lengthOf(subtract(first(), second())) },
    ),
  ],
  checks: ({ largest }) => [
    largest(
      12,
      'Largest |(a + b) − b − a|: subtraction undoes addition',
      { exact: 0, absolute: 1e-15 },
      ({ first, second }) => lengthOf(subtract(subtract(add(first(), second()), second()), first())),
    ),
    largest(12, 'Largest length of a/|a|', { exact: 1, absolute: 5e-16 }, ({ first }) => lengthOf(unit(first()))),
    largest(12, 'Largest a·b − b·a', { exact: 0, absolute: 0 }, ({ first, second }) =>
      Math.abs(dot(first(), second()) - dot(second(), first())),
    ),
    largest(
      12,
      'Largest deviation from |a + b|² + |a − b|² = 2 |a|² + 2 |b|²',
      { exact: 0, absolute: 1e-14 },
      ({ first, second }) => {
        const [a, b] = [first(), second()];
        const square = (v: Point) => dot(v, v);
        return Math.abs(square(add(a, b)) + square(subtract(a, b)) - 2 * square(a) - 2 * square(b));
      },
    ),
  ],
  tryThis: [
    'Give both the same length: when they point in opposite directions, the sum vanishes and the difference is longest.',
    'Watch for the moments at which sum and difference are equally long: the two arrows stand at a right angle.',
  ],
});
