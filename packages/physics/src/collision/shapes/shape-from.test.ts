// A shape that went through JSON is the same shape again.
import {
  box,
  capsule,
  chain,
  circle,
  polygon,
  type Shape,
  type ShapeRecord,
  segment,
  shapeFrom,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';

const corners = [{ x: 0.1 }, { x: 4, y: 0.3 }, { x: 2.7, y: 1.9 }, { x: 0.2, y: 1 }];
const line = [
  { x: 9, y: -3 },
  { x: 0.3, y: -3.1 },
  { x: -9, y: -2 },
  { x: -9, y: 5 },
];

const SHAPES: readonly (readonly [string, Shape])[] = [
  ['a circle', circle(0.3)],
  ['a box', box(2, 0.3)],
  ['a rounded box', box(2, 0.2, { rounding: 0.05 })],
  ['a capsule', capsule(0.7, 0.2)],
  ['a polygon', polygon(corners)],
  ['a rounded polygon', polygon(corners, { rounding: 0.1 })],
  ['a segment', segment({ x: 1, y: 2 }, { x: -3, y: 2.5 })],
  ...chain(line).map((piece, i) => [`piece ${i} of a chain`, piece] as const),
  ['a piece of a closed chain', chain(line, { closed: true })[3]],
];

const copyOf = (shape: Shape): ShapeRecord => JSON.parse(JSON.stringify(shape));

describe.each(SHAPES)('%s', (_name, shape) => {
  test('comes back with the same numbers', () => {
    const copy = shapeFrom(copyOf(shape));
    expect(copy.kind).toBe(shape.kind);
    // The centroid is computed again: some roundings of a double.
    const close = (a: readonly number[] = [], b: readonly number[] = []) => {
      expect(a.length).toBe(b.length);
      a.forEach((value, i) => {
        expect(Math.abs(value - b[i])).toBeLessThan(1e-14 * shape.extent);
      });
    };
    close(copy.vertices, shape.vertices);
    close(copy.normals, shape.normals);
    close(copy.neighbours, shape.neighbours);
    close([copy.radius, copy.area, copy.extent], [shape.radius, shape.area, shape.extent]);
    expect(Math.abs(copy.inertiaPerMass / shape.inertiaPerMass - 1)).toBeLessThan(1e-12);
  });
});

test.each([
  ['nothing', undefined],
  ['an unknown kind', { kind: 'star', vertices: [], radius: 1 }],
  ['vertices that are no list', { kind: 'polygon', vertices: 3, radius: 0 }],
  ['a segment of one point', { kind: 'segment', vertices: [0, 0], radius: 0 }],
  ['a vertex that is no number', { kind: 'polygon', vertices: [0, 0, 1, null, 1, 1], radius: 0 }],
  ['a chain of one neighbour', { kind: 'segment', vertices: [0, 0, 1, 0], radius: 0, neighbours: [-1, 0] }],
  ['a circle without a radius', { kind: 'circle', vertices: [0, 0] }],
])('%s is refused', (_name, record) => {
  expect(() => shapeFrom(record as ShapeRecord)).toThrow(/shapeFrom|polygon|chain|circle/);
});
