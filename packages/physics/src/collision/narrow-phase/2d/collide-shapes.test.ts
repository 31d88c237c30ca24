import { box, capsule, circle, createRandom, polygon, type Shape, segment } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import {
  type Pose,
  type Precision,
  pairTester,
  SPECULATIVE,
  TOLERANCE,
} from '../../../../../../test/support/shape-pairs.ts';

type Point = readonly [x: number, y: number];

type Found = ReturnType<ReturnType<typeof pairTester>>;

const collide = pairTester('f64');
const leastSeparation = ({ points }: Found) => Math.min(...points.map(({ separation }) => separation));

function verticesAt({ vertices }: Shape, [x, y, angle]: Pose): Point[] {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return Array.from({ length: vertices.length / 2 }, (_, i): Point => {
    const [vx, vy] = [vertices[2 * i], vertices[2 * i + 1]];
    return [x + c * vx - s * vy, y + s * vx + c * vy];
  });
}

function distanceToEdge([x, y]: Point, [ax, ay]: Point, [bx, by]: Point): number {
  const [ex, ey] = [bx - ax, by - ay];
  const square = ex * ex + ey * ey;
  const t = square === 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * ex + (y - ay) * ey) / square));
  return Math.hypot(x - ax - t * ex, y - ay - t * ey);
}

/** Distance of the outlines of two sets of vertices that do not overlap: some vertex is nearest to some edge. */
function distanceOf(a: readonly Point[], b: readonly Point[]): number {
  const least = (points: readonly Point[], outline: readonly Point[]) =>
    Math.min(
      ...points.flatMap((point) =>
        outline.map((start, i) => distanceToEdge(point, start, outline[(i + 1) % outline.length])),
      ),
    );
  return Math.min(least(a, b), least(b, a));
}

/** How far the second set begins behind the end of the first along a direction; negative where they overlap. */
function gapAlong(a: readonly Point[], b: readonly Point[], nx: number, ny: number): number {
  const along = ([x, y]: Point) => x * nx + y * ny;
  return Math.min(...b.map(along)) - Math.max(...a.map(along));
}

/** The greatest gap along the normals of both outlines: negative only where they overlap. A point has no normal. */
function greatestGap(a: readonly Point[], b: readonly Point[]): number {
  const gaps = (from: readonly Point[], sign: number) =>
    (from.length > 1 ? from : []).map(([x, y], i) => {
      const [nextX, nextY] = from[(i + 1) % from.length];
      const length = Math.hypot(nextX - x, nextY - y);
      return gapAlong(a, b, (sign * (nextY - y)) / length, (-sign * (nextX - x)) / length);
    });
  return Math.max(...gaps(a, 1), ...gaps(b, -1));
}

describe('two discs', () => {
  test('meet on the line of their centres', () => {
    const { nx, ny, points } = collide(circle(1), [1, 1, 0.3], circle(2), [1 + 2.9 * 0.6, 1 + 2.9 * 0.8, 2]);
    expect([nx, ny]).toEqual([expect.closeTo(0.6, 12), expect.closeTo(0.8, 12)]);
    expect(points).toHaveLength(1);
    expect(points[0].separation).toBeCloseTo(-0.1, 12);
    // Half-way between 1 and 0.9 m from the first centre.
    expect(points[0].x).toBeCloseTo(1 + 0.95 * 0.6, 12);
  });

  test('with one centre have a normal of length 1', () => {
    const { nx, ny, points } = collide(circle(1), [2, 3, 0], circle(1), [2, 3, 0]);
    expect(Math.hypot(nx, ny)).toBe(1);
    expect(points[0].separation).toBe(-2);
  });
});

describe('a disc and a box of 2 m by 1 m', () => {
  const rectangle = box(2, 1);
  const ball = circle(0.25);
  const at = (x: number, y: number) => collide(rectangle, [0, 0, 0], ball, [x, y, 0]);

  test('meet at an edge', () => {
    const { nx, ny, points } = at(0.3, 0.74);
    expect([nx, ny]).toEqual([0, 1]);
    expect(points[0]).toMatchObject({ x: expect.closeTo(0.3, 12), y: expect.closeTo(0.495, 12) });
    expect(points[0].separation).toBeCloseTo(-0.01, 12);
  });

  test('meet at a corner along the line from it to the centre', () => {
    const { nx, ny, points } = at(1 + 0.2 * 0.6, 0.5 + 0.2 * 0.8);
    expect([nx, ny]).toEqual([expect.closeTo(0.6, 12), expect.closeTo(0.8, 12)]);
    expect(points[0].separation).toBeCloseTo(-0.05, 12);
  });

  test('part where the corner is further than the radius, although both edges are nearer', () => {
    expect(at(1.2, 0.7).points).toHaveLength(0);
    expect(at(1.18, 0.68).points).toHaveLength(1);
  });

  test('meet through the nearest edge when the centre is inside', () => {
    const { nx, ny, points } = at(0.9, 0.1);
    expect([nx, ny]).toEqual([1, 0]);
    expect(points[0].separation).toBeCloseTo(-0.35, 12);
  });

  test('do not meet beyond the speculative distance', () => {
    expect(at(0, 0.76).points).toHaveLength(1);
    expect(at(0, 0.7701).points).toHaveLength(0);
  });
});

describe('two boxes', () => {
  test('side by side have two points at the ends of what their edges share', () => {
    const { nx, ny, points } = collide(box(2, 1), [0, 0, 0], box(2, 1), [0.5, 0.99, 0]);
    expect([nx, ny]).toEqual([0, 1]);
    expect(points.map(({ x }) => x).sort((p, q) => p - q)).toEqual([expect.closeTo(-0.5, 12), expect.closeTo(1, 12)]);
    for (const { y, separation } of points) {
      expect(separation).toBeCloseTo(-0.01, 12);
      expect(y).toBeCloseTo(0.495, 12);
    }
  });

  test('one of which stands on a corner have the depth of that corner', () => {
    const half = Math.SQRT1_2;
    const { nx, ny, points } = collide(box(4, 1), [0, 0, 0], box(1, 1), [0.3, 0.5 + half - 0.05, Math.PI / 4]);
    expect([nx, ny]).toEqual([expect.closeTo(0, 12), expect.closeTo(1, 12)]);
    const deepest = points.reduce((p, q) => (p.separation < q.separation ? p : q));
    expect(deepest.separation).toBeCloseTo(-0.05, 12);
    expect(deepest.x).toBeCloseTo(0.3, 12);
  });

  test('whose corners face each other meet along the line between them', () => {
    const [dx, dy] = [0.006, 0.008];
    const { nx, ny, points } = collide(box(1, 1), [0, 0, 0], box(1, 1), [1 + dx, 1 + dy, 0]);
    expect([nx, ny]).toEqual([expect.closeTo(0.6, 10), expect.closeTo(0.8, 10)]);
    expect(points).toHaveLength(1);
    expect(points[0].separation).toBeCloseTo(0.01, 12);
  });

  test('give the same contact as polygons that are not known to be boxes', () => {
    const random = createRandom(5);
    const [one, two] = [box(1, 0.6), box(0.8, 0.7)];
    const turned = ({ vertices: [ax, ay, bx, by, cx, cy, dx, dy] }: Shape) =>
      polygon([
        { x: bx, y: by },
        { x: cx, y: cy },
        { x: dx, y: dy },
        { x: ax, y: ay },
      ]);
    for (let i = 0; i < 300; i++) {
      const poses: [Pose, Pose] = [
        [0, 0, 6 * random.uniform()],
        [1.2 * random.uniform() - 0.6, 1.2 * random.uniform() - 0.6, 6 * random.uniform()],
      ];
      const quick = collide(one, poses[0], two, poses[1]);
      const slow = collide(turned(one), poses[0], turned(two), poses[1]);
      expect(leastSeparation(quick)).toBeCloseTo(leastSeparation(slow), 10);
      expect(quick.nx * slow.nx + quick.ny * slow.ny).toBeCloseTo(1, 10);
    }
  });
});

describe('two capsules of length 2 m and radius 0.25 m', () => {
  const rod = capsule(2, 0.25);

  test('side by side have two points', () => {
    const { nx, ny, points } = collide(rod, [0, 0, 0], rod, [0.5, 0.49, 0]);
    expect([nx, ny]).toEqual([0, 1]);
    expect(points.map(({ x }) => x).sort((p, q) => p - q)).toEqual([expect.closeTo(-0.5, 12), expect.closeTo(1, 12)]);
    expect(points[0].separation).toBeCloseTo(-0.01, 12);
  });

  test('end to end have one point between their ends', () => {
    const { nx, points } = collide(rod, [0, 0, 0], rod, [2.49, 0, 0]);
    expect(nx).toBeCloseTo(1, 12);
    expect(points).toHaveLength(1);
    expect(points[0]).toMatchObject({ x: expect.closeTo(1.245, 12), y: expect.closeTo(0, 12) });
    expect(points[0].separation).toBeCloseTo(-0.01, 12);
  });

  test('one with its end on the side of the other meet there', () => {
    const { nx, ny, points } = collide(rod, [0, 0, 0], rod, [0.3, 1.49, Math.PI / 2]);
    expect([nx, ny]).toEqual([expect.closeTo(0, 12), expect.closeTo(1, 12)]);
    expect(leastSeparation({ nx, ny, points })).toBeCloseTo(-0.01, 12);
  });

  test('whose axes cross are pushed apart the shorter way', () => {
    const { nx, ny, points } = collide(rod, [0, 0, 0], rod, [0.2, 0.9, Math.PI / 2]);
    // The upper one's axis ends 0.1 m below the lower one's.
    expect([nx, ny]).toEqual([expect.closeTo(0, 12), expect.closeTo(1, 12)]);
    expect(leastSeparation({ nx, ny, points })).toBeCloseTo(-0.6, 12);
  });
});

test('a ball meets both sides of a segment, and its ends', () => {
  const floor = segment({ x: -1 }, { x: 1 });
  expect(collide(floor, [0, 0, 0], circle(0.5), [0.5, 0.49, 0])).toMatchObject({ nx: 0, ny: 1 });
  expect(collide(floor, [0, 0, 0], circle(0.5), [0.5, -0.49, 0])).toMatchObject({ nx: 0, ny: -1 });
  const { nx, ny, points } = collide(floor, [0, 0, 0], circle(0.5), [1 + 0.48 * 0.6, 0.48 * 0.8, 0]);
  expect([nx, ny]).toEqual([expect.closeTo(0.6, 12), expect.closeTo(0.8, 12)]);
  expect(points[0].separation).toBeCloseTo(-0.02, 12);
});

test('a box rests on a segment with two points', () => {
  const floor = segment({ x: -5 }, { x: 5 });
  const { nx, ny, points } = collide(floor, [0, 0, 0], box(1, 1), [2, 0.495, 0]);
  expect([nx, ny]).toEqual([0, 1]);
  expect(points.map(({ separation }) => separation)).toEqual([expect.closeTo(-0.005, 12), expect.closeTo(-0.005, 12)]);
});

/** Convex because the corners lie on an ellipse. */
function randomPolygon(random: () => number): Shape {
  const count = 3 + Math.floor(6 * random());
  const [width, height, start] = [0.2 + random(), 0.2 + random(), random()];
  const points = Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * (i + start + 0.6 * random())) / count;
    return { x: width * Math.cos(angle), y: height * Math.sin(angle) };
  });
  return polygon(points, { rounding: random() < 0.5 ? 0.1 * random() : 0 });
}

function randomShape(random: () => number): Shape {
  const kind = random();
  if (kind < 0.5) return randomPolygon(random);
  if (kind < 0.65) return box(0.2 + random(), 0.2 + random());
  if (kind < 0.8) return capsule(0.1 + random(), 0.05 + 0.3 * random());
  return kind < 0.9 ? circle(0.1 + random()) : segment({ x: -random() - 0.1 }, { x: 0.1, y: random() });
}

describe.each<[Precision, number]>([
  ['f64', 1e-11],
  // Sizes and positions of a metre have 1e-7 m in f32.
  ['f32', 2e-6],
])('random convex shapes in %s', (precision, rounding) => {
  const pair = pairTester(precision);
  const { uniform } = createRandom(7);
  const random = () => uniform();
  const cases = Array.from({ length: 4000 }, () => {
    const [a, b] = [randomShape(random), randomShape(random)];
    const angle = 2 * Math.PI * random();
    // Near enough to touch about every second time.
    const reach = (0.55 + 0.5 * random()) * (a.extent + b.extent);
    const poseA: Pose = [random(), random(), 2 * Math.PI * random()];
    const poseB: Pose = [
      poseA[0] + reach * Math.cos(angle),
      poseA[1] + reach * Math.sin(angle),
      2 * Math.PI * random(),
    ];
    return { a, b, poseA, poseB };
  });

  test('have the distance that all pairs of vertices and edges give', () => {
    let [apart, deep] = [0, 0];
    for (const { a, b, poseA, poseB } of cases) {
      const found = pair(a, poseA, b, poseB);
      const [verticesA, verticesB] = [verticesAt(a, poseA), verticesAt(b, poseB)];
      const radii = a.radius + b.radius;
      const onlyPoints = verticesA.length + verticesB.length === 2;
      const gap = onlyPoints ? 0 : greatestGap(verticesA, verticesB);
      const distance = distanceOf(verticesA, verticesB);
      if (gap < 0) {
        // The contact is never deeper than the least way out; corners beyond the reference edge may make it shallower.
        expect(found.points.length).toBeGreaterThan(0);
        expect(leastSeparation(found)).toBeGreaterThan(gap - radii - rounding);
        deep++;
      } else if (distance - radii > SPECULATIVE + rounding) {
        expect(found.points).toHaveLength(0);
      } else if (distance - radii < SPECULATIVE - rounding) {
        expect(found.points.length).toBeGreaterThan(0);
        expect(leastSeparation(found)).toBeGreaterThan(distance - radii - rounding);
        expect(leastSeparation(found)).toBeLessThan(distance - radii + TOLERANCE + rounding);
        const along = gapAlong(verticesA, verticesB, found.nx, found.ny);
        expect(along).toBeGreaterThan(distance - TOLERANCE - rounding / Math.max(distance, 1e-3));
        apart++;
      }
    }
    expect(Math.min(apart, deep)).toBeGreaterThan(300);
  });

  test('have a normal of length 1, and no points beyond the speculative distance', () => {
    for (const { a, b, poseA, poseB } of cases) {
      const { nx, ny, points } = pair(a, poseA, b, poseB);
      if (points.length > 0) expect(Math.hypot(nx, ny)).toBeCloseTo(1, precision === 'f64' ? 12 : 5);
      for (const { separation } of points) expect(separation).toBeLessThanOrEqual(Math.fround(SPECULATIVE));
    }
  });

  test('give the opposite normal and the same separation when they are swapped', () => {
    for (const { a, b, poseA, poseB } of cases) {
      const one = pair(a, poseA, b, poseB);
      const two = pair(b, poseB, a, poseA);
      if (one.points.length === 0 || two.points.length === 0) continue;
      // Of two edges that are equally far apart either may be the reference.
      expect(Math.abs(leastSeparation(one) - leastSeparation(two))).toBeLessThan(TOLERANCE + rounding);
    }
  });

  test('give the same contact wherever the pair is and however it is turned', () => {
    const [turn, x, y] = [1.1, 3, -2];
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    const moved = ([px, py, angle]: Pose): Pose => [x + c * px - s * py, y + s * px + c * py, angle + turn];
    for (const { a, b, poseA, poseB } of cases) {
      const one = pair(a, poseA, b, poseB);
      const two = pair(a, moved(poseA), b, moved(poseB));
      if (one.points.length === 0 || two.points.length === 0) continue;
      expect(Math.abs(leastSeparation(one) - leastSeparation(two))).toBeLessThan(TOLERANCE + 3 * rounding);
    }
  });
});

describe('feature ids', () => {
  test('stay the same while a box slides and rocks on another', () => {
    const idsAt = (x: number, angle: number) => {
      const { points } = collide(box(6, 1), [0, 0, 0.001], box(1, 1), [x, 0.999, angle]);
      return points.map(({ id }) => id).sort((p, q) => p - q);
    };
    const first = idsAt(0, 0);
    expect(first).toHaveLength(2);
    // On both sides of the angle at which the reference edge changes from one box to the other.
    for (let i = 0; i <= 40; i++) expect(idsAt(0.01 * i, 1e-4 * i)).toEqual(first);
  });

  test('of the two points of a contact differ', () => {
    const { points } = collide(box(1, 1), [0, 0, 0], box(1, 1), [0, 0.99, 0]);
    expect(new Set(points.map(({ id }) => id)).size).toBe(2);
  });

  test(`do not depend on which of the two is named first, but for the order of their bytes`, () => {
    const [one, two] = [box(1, 1), box(0.6, 0.6)];
    const poseA: Pose = [0, 0, 0];
    const poseB: Pose = [0.1, 0.79, 0.01];
    const ids = collide(one, poseA, two, poseB).points.map(({ id }) => id);
    const swapped = collide(two, poseB, one, poseA).points.map(({ id }) => ((id & 255) << 8) | (id >> 8));
    expect(swapped.sort()).toEqual(ids.sort());
  });
});

test('far from the origin, where f32 has 0.5 mm, the separation has the digits of the difference of positions', () => {
  const pair = pairTester('f32');
  // Both positions are multiples of 1/2048 m, so that their difference is exact.
  const [x, y] = [4096.5, -8190.25];
  const overlap = 3 / 2048;
  const { nx, ny, points } = pair(box(1, 1), [x, y, 0], box(1, 1), [x + 0.25, y + 1 - overlap, 0]);
  expect([nx, ny]).toEqual([0, 1]);
  expect(points.map(({ separation }) => separation)).toEqual([
    expect.closeTo(-overlap, 7),
    expect.closeTo(-overlap, 7),
  ]);
});
