// A shape that went through JSON is the same shape again.
import {
  box,
  capsule,
  chain,
  circle,
  createPhysicsWorld,
  createRandom,
  polygon,
  rigidBodies,
  type Shape,
  type ShapeRecord,
  segment,
  shapeFrom,
  spawn,
  stateHash,
  step,
  uniformGravity,
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
  test('comes back with the same bits', () => {
    expect(shapeFrom(copyOf(shape))).toEqual(shape);
    expect(JSON.stringify(shapeFrom(copyOf(shape)))).toBe(JSON.stringify(shape));
  });

  test('comes back from its vertices with the same numbers', () => {
    const { kind, vertices, radius, neighbours } = copyOf(shape);
    const copy = shapeFrom({ kind, vertices, radius, neighbours });
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

test('polygons of any form and place come back with the same bits', () => {
  const random = createRandom(4);
  for (let i = 0; i < 500; i++) {
    const count = 3 + Math.floor(6 * random.uniform());
    const [x, y, size] = [2000 * random.uniform() - 1000, 10 * random.uniform(), 0.1 + 3 * random.uniform()];
    const points = Array.from({ length: count }, (_, k) => {
      const angle = (2 * Math.PI * (k + 0.3 * random.uniform())) / count;
      return { x: x + size * Math.cos(angle), y: y + size * Math.sin(angle) };
    });
    const shape = polygon(points, i % 2 === 0 ? {} : { rounding: 0.1 });
    expect(shapeFrom(copyOf(shape))).toEqual(shape);
  }
});

test.each(['f32', 'f64'] as const)(
  'a level that is loaded has the hash of the one that was built, and goes its way: %s',
  (precision) => {
    const build = (use: (shape: Shape) => Shape) => {
      const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 60, forces: [uniformGravity()] });
      for (const piece of chain(line)) spawn(world, { position: piece.centre, collider: { shape: use(piece) } });
      for (let i = 0; i < 5; i++) {
        const shape = polygon([{ x: i }, { x: i + 1 }, { x: i + 0.3 + i / 10, y: 1 }]);
        spawn(world, { position: { x: i - 2, y: 2 + i }, collider: { shape: use(shape), density: 10, friction: 0.5 } });
      }
      return world;
    };
    const [built, loaded] = [build((shape) => shape), build((shape) => shapeFrom(copyOf(shape)))];
    expect(stateHash(loaded)).toBe(stateHash(built));
    for (let i = 0; i < 120; i++) for (const world of [built, loaded]) step(world, 1 / 60);
    expect(stateHash(loaded)).toBe(stateHash(built));
  },
);

test('what was changed is computed anew, about the place where the vertices are counted from', () => {
  const square = polygon([{ x: 1 }, { x: 2 }, { x: 2, y: 1 }, { x: 1, y: 1 }]);
  const wider = shapeFrom({ ...square, vertices: [-0.5, -0.5, 1.5, -0.5, 1.5, 0.5, -0.5, 0.5] });
  expect(wider.vertices).toEqual([-1, -0.5, 1, -0.5, 1, 0.5, -1, 0.5]);
  expect(wider.area).toBe(2);
  expect(wider.centre).toEqual({ x: 2, y: 0.5 });
});

test.each([
  ['nothing', undefined],
  ['an unknown kind', { kind: 'star', vertices: [], radius: 1 }],
  ['vertices that are no list', { kind: 'polygon', vertices: 3, radius: 0 }],
  ['a segment of one point', { kind: 'segment', vertices: [0, 0], radius: 0 }],
  ['a vertex that is no number', { kind: 'polygon', vertices: [0, 0, 1, null, 1, 1], radius: 0 }],
  ['a chain of one neighbour', { kind: 'segment', vertices: [0, 0, 1, 0], radius: 0, neighbours: [-1, 0] }],
  ['a circle without a radius', { kind: 'circle', vertices: [0, 0] }],
  ['a centre that is no place', { kind: 'circle', vertices: [0, 0], radius: 1, centre: { x: null, y: 0 } }],
])('%s is refused', (_name, record) => {
  expect(() => shapeFrom(record as ShapeRecord)).toThrow(/shapeFrom|polygon|chain|circle/);
});
