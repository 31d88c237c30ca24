import { describe, expect, test } from 'vitest';
import { box, capsule, circle, createPhysicsWorld, createRandom, type Shape, segment } from '../../../index.ts';
import { allocate } from '../../../memory/arena.ts';
import { realBytes } from '../../../memory/columns.ts';
import { SHAPE_BYTES, SWEEP_BYTES } from '../../../memory/layouts.gen.ts';
import { rigidKernels } from '../../kernels.ts';
import { writeShape } from '../../shapes/store-shape.ts';

type Pose = readonly [x: number, y: number, angle: number];
type Path = readonly [start: Pose, end: Pose];

const TARGET = 1e-3;

function sweepTester(precision: 'f32' | 'f64') {
  const world = createPhysicsWorld({ capacity: 1, precision });
  const { arena } = world.internal;
  const [sweep, first, second] = [SWEEP_BYTES, SHAPE_BYTES, SHAPE_BYTES].map((bytes) =>
    allocate(arena, bytes[precision], 'a sweep'),
  );
  const { buffer } = world.memory;
  const Reals = precision === 'f32' ? Float32Array : Float64Array;
  const reals = new Reals(buffer, sweep + realBytes(precision), SWEEP_BYTES[precision] / realBytes(precision) - 1);
  const rotated = ([x, y, angle]: Pose) => [x, y, Math.cos(angle), Math.sin(angle)];
  return (a: Shape, pathA: Path, b: Shape, pathB: Path, target = TARGET) => {
    writeShape(world, first, a);
    writeShape(world, second, b);
    reals.set([...pathA.flatMap(rotated), ...pathB.flatMap(rotated), target]);
    rigidKernels(world).sweepPair(sweep, first, second);
    const [fraction, nx, ny, x, y] = reals.slice(17);
    return { isHit: new Uint32Array(buffer, sweep, 1)[0] === 1, fraction, nx, ny, x, y };
  };
}

const still = (x: number, y: number, angle = 0): Path => [
  [x, y, angle],
  [x, y, angle],
];
const moving = (x: number, y: number, dx: number, dy: number, turn = 0): Path => [
  [x, y, 0],
  [x + dx, y + dy, turn],
];

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  const sweep = sweepTester(precision);
  const digits = precision === 'f32' ? 4 : 9;

  test('a ball of 2000 m/s never passes a wall of 0.05 m, wherever in the step it meets it', () => {
    // 1/60 s: 33 m a step.
    const wall = box(0.05, 10);
    for (let i = 0; i < 200; i++) {
      const start = -0.17 * i - 0.2;
      const { isHit, fraction, nx } = sweep(wall, still(0, 0), circle(0.1), moving(start, 0, 2000 / 60, 0));
      const reach = -start - 0.125;
      if (reach > 2000 / 60) {
        expect([isHit, fraction]).toEqual([false, 1]);
        continue;
      }
      expect(isHit).toBe(true);
      expect(nx).toBeCloseTo(-1, digits);
      const x = start + (fraction * 2000) / 60;
      // It stops in front of the wall, at most one and a quarter of the target from it.
      expect(x).toBeLessThan(-0.125);
      expect(x).toBeGreaterThan(-0.125 - 1.3 * TARGET - (precision === 'f32' ? 1e-5 : 0));
    }
  });

  test('a rod that only turns meets what its end sweeps over', () => {
    const rod = capsule(2, 0.1);
    const ball = circle(0.2);
    const { isHit, fraction } = sweep(ball, still(0.6, 0.4), rod, moving(0, 0, 0, 0, Math.PI / 2));
    expect(isHit).toBe(true);
    // They touch when the distance of (0.6, 0.4) from the axis is the sum of the radii.
    const angle = Math.atan2(0.4, 0.6) - Math.asin(0.3 / Math.hypot(0.6, 0.4));
    // The angle at a fraction t of a quarter turn whose cosine and sine are interpolated.
    const reached = Math.atan2(fraction, 1 - fraction);
    expect(reached).toBeLessThan(angle);
    expect(reached).toBeGreaterThan(angle - (2 * TARGET) / 0.65);
  });

  test('bodies that part, pass each other or do not reach each other do not meet', () => {
    const one = box(1, 1);
    for (const path of [moving(2, 0, 30, 0), moving(-10, 1.2, 20, 0), moving(5, 0, -3.9, 0)]) {
      expect(sweep(one, still(0, 0), one, path)).toMatchObject({ isHit: false, fraction: 1 });
    }
  });

  test('bodies that are near at the start meet at once', () => {
    expect(sweep(box(1, 1), still(0, 0), box(1, 1), moving(1.0005, 0, 5, 0))).toMatchObject({
      isHit: true,
      fraction: 0,
    });
    const inside = sweep(segment({ x: -1 }, { x: 1 }), still(0, 0), box(1, 1), moving(0, 0.2, 0, -5));
    expect(inside).toMatchObject({ isHit: true, fraction: 0, nx: 0, ny: 0 });
  });

  test('two bodies that both move meet where their relative motion brings them', () => {
    const { fraction, x, nx } = sweep(circle(0.5), moving(-10, 0, 20, 0), circle(0.5), moving(10, 0, -20, 0));
    expect(fraction).toBeGreaterThan((19 - 1.3 * TARGET) / 40 - 1e-6);
    expect(fraction).toBeLessThan(19 / 40);
    expect([x, nx]).toEqual([expect.closeTo(0, digits), expect.closeTo(1, digits)]);
  });
});

test('at the impact the shapes are as near as the target, and never before, for random motions', () => {
  const sweep = sweepTester('f64');
  const random = createRandom(11);
  const shapes = [box(1, 0.4), capsule(1, 0.2), circle(0.4), box(0.7, 0.7, { rounding: 0.1 })];
  const pick = () => shapes[random.integer(0, shapes.length - 1)];
  let hits = 0;
  for (let i = 0; i < 500; i++) {
    const [a, b] = [pick(), pick()];
    const pose = (reach: number): Pose => [
      random.uniform(-reach, reach),
      random.uniform(-reach, reach),
      random.uniform(0, 1),
    ];
    const [pathA, pathB]: Path[] = [
      [pose(1), pose(1)],
      [pose(6), pose(6)],
    ];
    const at = (t: number): [Path, Path] => {
      const between = ([[x0, y0, angle0], [x1, y1, angle1]]: Path): Pose => [
        x0 + t * (x1 - x0),
        y0 + t * (y1 - y0),
        Math.atan2(
          Math.sin(angle0) + t * (Math.sin(angle1) - Math.sin(angle0)),
          Math.cos(angle0) + t * (Math.cos(angle1) - Math.cos(angle0)),
        ),
      ];
      return [still(...between(pathA)), still(...between(pathB))];
    };
    const isWithin = (target: number, t: number) => {
      const [placeA, placeB] = at(t);
      // What does not move meets where it is nearer than one and a quarter of the target.
      return sweep(a, placeA, b, placeB, 0.8 * target).isHit;
    };
    const { isHit, fraction } = sweep(a, pathA, b, pathB);
    for (let k = 0; k < 50; k++) {
      const t = (k / 50) * fraction;
      if (t < fraction - 1e-9) expect(isWithin(0.999 * TARGET, t)).toBe(false);
    }
    if (!isHit) continue;
    expect(isWithin(1.26 * TARGET, fraction)).toBe(true);
    hits++;
  }
  expect(hits).toBeGreaterThan(30);
});
