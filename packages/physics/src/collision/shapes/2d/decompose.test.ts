// Pieces of concave outlines: convex, without overlap, and of the same area, centroid and moment of inertia.
import {
  box,
  createPhysicsWorld,
  createRandom,
  decompose,
  polygon,
  rigidBodies,
  type Shape,
  spawn,
  spawnCompound,
  step,
  uniformGravity,
} from '@principia/physics';
import { describe, expect, it, test } from 'vitest';

type Point = { x: number; y: number };
const outline = (...xy: number[]): Point[] =>
  Array.from({ length: xy.length / 2 }, (_, i) => ({ x: xy[2 * i], y: xy[2 * i + 1] }));

/** Area, first moments and polar moment of any simple polygon about the origin, by Green's theorem. */
function moments(points: readonly Point[]) {
  let [area, x, y, polar] = [0, 0, 0, 0];
  for (const [i, a] of points.entries()) {
    const b = points[(i + 1) % points.length];
    const cross = a.x * b.y - a.y * b.x;
    area += cross / 2;
    x += (cross * (a.x + b.x)) / 6;
    y += (cross * (a.y + b.y)) / 6;
    polar += (cross * (a.x * a.x + a.x * b.x + b.x * b.x + a.y * a.y + a.y * b.y + b.y * b.y)) / 12;
  }
  return [area, x, y, polar].map((value) => value * Math.sign(area));
}

function momentsOfPieces(pieces: readonly { shape: Shape; x: number; y: number }[]) {
  return pieces.reduce(
    ([area, mx, my, polar], { shape, x, y }) => [
      area + shape.area,
      mx + shape.area * x,
      my + shape.area * y,
      polar + shape.area * (shape.inertiaPerMass + x * x + y * y),
    ],
    [0, 0, 0, 0],
  );
}

const STAR = Array.from({ length: 10 }, (_, i) => {
  const [r, angle] = [i % 2 === 0 ? 1 : 0.4, (i * Math.PI) / 5];
  return { x: r * Math.cos(angle), y: r * Math.sin(angle) };
});
const COMB = outline(0, 0, 7, 0, 7, 3, 6, 3, 6, 1, 5, 1, 5, 3, 4, 3, 4, 1, 3, 1, 3, 3, 2, 3, 2, 1, 1, 1, 1, 3, 0, 3);

describe.each([
  ['an L', outline(0, 0, 2, 0, 2, 1, 1, 1, 1, 3, 0, 3), 2],
  ['an L clockwise', outline(0, 0, 2, 0, 2, 1, 1, 1, 1, 3, 0, 3).reverse(), 2],
  ['a square with corners on its sides', outline(0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1), 1],
  [
    'a convex polygon of twelve corners',
    Array.from({ length: 12 }, (_, i) => ({ x: Math.cos(i / 2), y: Math.sin(i / 2) })),
    2,
  ],
  ['a star', STAR, 6],
  ['a comb', COMB, 9],
] as const)('%s', (_, points, most) => {
  it('has pieces of the same area, centroid and inertia', () => {
    const pieces = decompose(points);
    expect(pieces.length).toBeLessThanOrEqual(most);
    const expected = moments(points);
    for (const [i, value] of momentsOfPieces(pieces).entries()) expect(value).toBeCloseTo(expected[i], 10);
  });
});

test('random outlines round a centre keep their moments', () => {
  const random = createRandom(1);
  for (let round = 0; round < 60; round++) {
    const count = Math.floor(random.uniform(3, 60));
    const points = Array.from({ length: count }, (_, i) => {
      const [r, angle] = [random.uniform(0.2, 2), (2 * Math.PI * (i + random.uniform(0, 0.8))) / count];
      return { x: 5 + r * Math.cos(angle), y: r * Math.sin(angle) };
    });
    const expected = moments(points);
    // Corners that are nearly in line are left out: they change areas by a part in 1e5.
    for (const [i, value] of momentsOfPieces(decompose(points)).entries()) {
      expect(Math.abs(value - expected[i])).toBeLessThan(1e-4 * Math.abs(expected[3]));
    }
  }
});

test('a bowl of pieces holds a ball', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity()], capacity: 50 });
  spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.6 } });
  const bowl = outline(-1, 0, 1, 0, 1.5, 1, 1.3, 1, 0.8, 0.2, -0.8, 0.2, -1.3, 1, -1.5, 1);
  spawnCompound(world, { parts: decompose(bowl).map((piece) => ({ ...piece, density: 100, friction: 0.6 })) });
  const ball = spawn(world, { position: { x: 0.1, y: 2 }, collider: { radius: 0.2, density: 10 } });
  for (let i = 0; i < 240; i++) step(world, 1 / 60);
  expect(world.components.Position.y[ball]).toBeCloseTo(0.4, 2);
});

test('outlines that cannot be divided are refused, with the corners that are at fault', () => {
  const refused = (message: RegExp) =>
    expect.objectContaining({ code: 'E_RANGE', message: expect.stringMatching(message) });
  expect(() => decompose(outline(0, 0, 1, 1, 1, 0, 0, 1))).toThrow(
    refused(/edge from corner 0 to 1 meets that from 2 to 3/),
  );
  expect(() => decompose(outline(0, 0, 4, 0, 4, 2, 2, 0, 0, 2))).toThrow(refused(/edge from corner 0 to 1 meets/));
  expect(() => decompose(outline(0, 0, 2, 0, 1, 0, 1, 1))).toThrow(refused(/turns back on itself at corner 1/));
  expect(() => decompose(outline(0, 0, 1, 0))).toThrow(refused(/has 2 corners/));
  expect(() => decompose(outline(0, 0, 0, 0, 1, 1))).toThrow(refused(/corners 0 and 1 are 0 m apart/));
  expect(() => decompose(outline(0, 0, 1, 0, 1, Number.NaN))).toThrow(expect.objectContaining({ code: 'E_NONFINITE' }));
  expect(() => decompose(undefined as never)).toThrow(expect.objectContaining({ code: 'E_TYPE' }));
  // What `polygon` refuses, it sends here.
  expect(() => polygon(outline(0, 0, 2, 0, 2, 1, 1, 1, 1, 3, 0, 3))).toThrow(
    expect.objectContaining({ hint: expect.stringMatching(/decompose/) }),
  );
});
