// Segments of chains: bodies meet them from one side, and slide over their points without a hitch.
import {
  box,
  capsule,
  chain,
  circle,
  createPhysicsWorld,
  createRandom,
  PhysicsError,
  polygon,
  rigidBodies,
  type Shape,
  spawn,
  spawnChain,
  step,
  uniformGravity,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { pairTester } from '../../../../../../test/support/shape-pairs.ts';

const collide = pairTester('f64');
const close = (value: number) => expect.closeTo(value, 10);

/** A flat floor along y = 0 from x = 2 to -2 in four pieces, and where the centre of each is. */
const floor = chain([{ x: 2 }, { x: 1 }, { x: 0 }, { x: -1 }, { x: -2 }]);
const meet = (segment: Shape, shape: Shape, x: number, y: number, angle = 0) =>
  collide(segment, [segment.centre.x, segment.centre.y, 0], shape, [x, y, angle]);

describe('a flat chain', () => {
  const shapes = [box(1, 1), circle(0.5), capsule(0.6, 0.5), box(1, 1, { rounding: 0.2 })];

  it.each(shapes)('gives only normals of its own, however deep a body is and wherever (%#)', (shape) => {
    const random = createRandom(2);
    for (let i = 0; i < 500; i++) {
      const [x, y, angle] = [random.uniform(-2, 2), random.uniform(0.3, 0.6), random.uniform(-0.3, 0.3)];
      for (const segment of floor) {
        const { nx, ny, points } = meet(segment, shape, x, y, angle);
        if (points.length > 0) expect([nx, ny]).toEqual([close(0), close(1)]);
      }
    }
  });

  it('lets pass what has its centre below it', () => {
    for (const shape of shapes)
      for (const segment of floor) expect(meet(segment, shape, 0.3, -0.01).points).toEqual([]);
  });

  it('holds a box by the same points whichever of the two is named first', () => {
    const [segment] = floor;
    const forward = meet(segment, box(1, 1), 1.5, 0.49);
    const backward = collide(box(1, 1), [1.5, 0.49, 0], segment, [segment.centre.x, segment.centre.y, 0]);
    expect(forward.points).toHaveLength(2);
    expect([backward.nx, backward.ny]).toEqual([close(0), close(-1)]);
    expect(backward.points.map(({ separation }) => separation)).toEqual([close(-0.01), close(-0.01)]);
  });
});

describe('the corner of a chain', () => {
  // A hill: its right flank rises to the left, its left one falls to the left.
  const hill = chain([{ x: 1, y: -1 }, {}, { x: -1, y: -1 }]);
  // A valley.
  const valley = chain([{ x: 1, y: 1 }, {}, { x: -1, y: 1 }]);
  const normals = (segments: Shape[], shape: Shape, x: number, y: number, angle = 0) =>
    segments.flatMap((segment) => {
      const { nx, ny, points } = meet(segment, shape, x, y, angle);
      return points.length > 0 ? [[nx, ny]] : [];
    });

  it('meets a disc with the normal from the corner where it is convex, and once', () => {
    expect(normals(hill, circle(0.5), 0, 0.49)).toEqual([[close(0), close(1)]]);
    expect(normals(hill, circle(0.5), 0.2 * 0.49, 0.49 * Math.sqrt(0.96))).toEqual([
      [close(0.2), close(Math.sqrt(0.96))],
    ]);
  });

  it('meets a box that lies on a convex corner with the normal of the box', () => {
    for (const [nx, ny] of normals(hill, box(1, 1), 0.1, 0.49)) expect([nx, ny]).toEqual([close(0), close(1)]);
    expect(normals(hill, box(1, 1), 0.1, 0.49).length).toBeGreaterThan(0);
  });

  it('meets with both flanks what lies in a concave one', () => {
    const half = Math.SQRT1_2;
    const both = [
      [close(-half), close(half)],
      [close(half), close(half)],
    ];
    expect(normals(valley, circle(0.5), 0, 0.5 * Math.SQRT2 - 0.01)).toEqual(both);
    expect(normals(valley, box(1, 1), 0, Math.SQRT1_2 - 0.01, Math.PI / 4)).toEqual(both);
  });
});

it('a box slides over the points of a flat chain as over one floor', () => {
  // Box2D calls what is absent here ghost collisions. There is no friction, so nothing may change the velocity.
  const world = createPhysicsWorld({ preset: rigidBodies, forces: [uniformGravity()], capacity: 100 });
  spawnChain(
    world,
    Array.from({ length: 41 }, (_, i) => ({ x: 20 - i })),
  );
  const body = spawn(world, {
    position: { x: -15, y: 0.5 },
    velocity: { x: 7 },
    collider: { shape: box(1, 1), density: 1 },
  });
  const { Position, Velocity, Rotation } = world.components;
  for (let i = 0; i < 240; i++) {
    step(world, 1 / 60);
    expect(Math.abs(Velocity.x[body] - 7)).toBeLessThan(1e-12);
    expect(Math.abs(Rotation.angle[body])).toBeLessThan(1e-4);
    expect(Math.abs(Position.y[body] - 0.5)).toBeLessThan(0.006);
  }
  expect(Position.x[body]).toBeCloseTo(13, 9);
});

it('chains that cannot be are refused, and nothing is made', () => {
  const world = createPhysicsWorld({ capacity: 3 });
  const codeOf = (make: () => unknown) => {
    try {
      return make();
    } catch (error) {
      return error instanceof PhysicsError ? error.code : error;
    }
  };
  expect(codeOf(() => chain([{}]))).toBe('E_RANGE');
  expect(codeOf(() => chain([{}, { x: 1 }], { closed: true }))).toBe('E_RANGE');
  expect(codeOf(() => chain([{}, { x: 1 }, { x: 1 }]))).toBe('E_RANGE');
  expect(codeOf(() => chain('floor' as never))).toBe('E_TYPE');
  expect(codeOf(() => spawnChain(world, [{}, { x: 1 }, { x: 2 }], { friction: -1 }))).toBe('E_RANGE');
  expect(codeOf(() => spawnChain(world, [{}, { x: 1 }, { x: 2 }, { x: 3 }, { x: 4 }]))).toBe('E_CAPACITY');
  expect(world.internal.counts.Collider).toBe(0);
  expect(chain([{}, { x: 1 }, { y: 1 }], { closed: true })).toHaveLength(3);
  expect(polygon([{}, { x: 1 }, { y: 1 }]).neighbours).toBeUndefined();
});
