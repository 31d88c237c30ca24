import { describe, expect, test } from 'vitest';
import { run } from '../../../../test/support/laws.ts';
import {
  box,
  buoyancy,
  capsule,
  circle,
  createPhysicsWorld,
  immersedDrag,
  linearDrag,
  polygon,
  polygonBuoyancy,
  rigidBodies,
  type Shape,
  segment,
  spawn,
  spawnMany,
  uniformGravity,
} from '../index.ts';

const SEA = { density: 1000, level: 0 };
const [width, height] = [4, 0.4];

test('a barge that is spawned with its shape floats at its draft', () => {
  const forces = [uniformGravity(), buoyancy(SEA), linearDrag()];
  const world = createPhysicsWorld({ preset: rigidBodies, precision: 'f64', forces });
  const hull = { volume: width * height, shape: 1 };
  const collider = { shape: box(width, height), density: 250 };
  const barge = spawn(world, { position: { y: 0.3 }, collider, hull, linearDrag: 800, neverSleep: {} });
  run(world, 60);
  // A quarter of it is under water: its centre is a quarter of the height above. Damped at 1/s for a minute, to e⁻⁶⁰ of 0.2 m.
  expect(world.components.Position.y[barge]).toBeCloseTo(height / 4, 9);
});

describe('the half height of a hull', () => {
  const world = createPhysicsWorld({ precision: 'f64', capacity: 40 });
  const { halfHeight, volume } = world.components.Hull;

  test('is that of the upright shape, and not of the circle around it', () => {
    const triangle = polygon([{ x: 0 }, { x: 3 }, { y: 3 }]);
    const cases = [
      [box(4, 0.4), 0.2],
      [box(4, 0.4, { rounding: 0.1 }), 0.2],
      [capsule(3, 0.25), 0.25],
      [circle(0.7), 0.7],
      [triangle, 1.5],
    ] as const;
    for (const [shape, half] of cases) {
      for (const hull of [2, { volume: 2 }]) {
        const body = spawn(world, { position: {}, collider: { shape }, hull });
        expect(halfHeight[body]).toBeCloseTo(half, 12);
        expect(volume[body]).toBe(2);
      }
    }
  });

  test('and its volume is a metre of the shape, or 1 m³ where that has no area', () => {
    const volumeOf = (shape: Shape, hull: object = { shape: 1 }) =>
      volume[spawn(world, { position: {}, collider: { shape }, hull })];
    expect(volumeOf(box(4, 0.4))).toBeCloseTo(1.6, 12);
    expect(volumeOf(circle(0.7))).toBeCloseTo(Math.PI * 0.49, 12);
    expect(volumeOf(segment({}, { x: 2 }))).toBe(1);
    expect(volumeOf(box(4, 0.4), { volume: 0 })).toBe(0);
  });

  test('is as given where it is given, also zero, and of each of many', () => {
    for (const half of [0, 3]) {
      const hull = { volume: 2, halfHeight: half };
      expect(halfHeight[spawn(world, { position: {}, collider: { shape: box(4, 0.4) }, hull })]).toBe(half);
    }
    for (const hull of [[1, 2], new Float64Array([1, 2]), { volume: [1, 2] }]) {
      const ids = [...spawnMany(world, 2, { position: {}, collider: { shape: box(4, 0.4) }, hull })];
      expect(ids.map((id) => [volume[id], halfHeight[id]])).toEqual([
        [1, 0.2],
        [2, 0.2],
      ]);
    }
  });

  test('of a polygon is that of its collider for the drag in the fluid', () => {
    const corners = [
      { x: -width / 2, y: -height / 2 },
      { x: width / 2, y: -height / 2 },
      { x: width / 2, y: height / 2 },
      { x: -width / 2, y: height / 2 },
    ];
    const forces = [
      polygonBuoyancy({ ...SEA, gravity: { y: -1e-9 } }, { shape: 2, vertices: corners }),
      immersedDrag(SEA),
    ];
    const slowedAt = (y: number) => {
      const sea = createPhysicsWorld({ forces });
      const body = { position: { y }, velocity: { x: 1 }, mass: 1000, linearDrag: 1, hull: { volume: 1.6, shape: 2 } };
      const barge = spawn(sea, { ...body, collider: { shape: box(width, height) } });
      run(sea, 1e-3, 1e-3);
      return (1 - sea.components.Velocity.x[barge]) * 1e6;
    };
    // One part in 10⁶ of the speed is lost, which is a mistake of 10⁻⁶ in the force.
    expect(slowedAt(1.5)).toBe(0);
    expect(slowedAt(0)).toBeCloseTo(0.5, 5);
    expect(slowedAt(-1)).toBeCloseTo(1, 5);
  });
});
