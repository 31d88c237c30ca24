import { addComponent, set } from 'bitecs';
import { describe, expect, test } from 'vitest';
import {
  box,
  capsule,
  circle,
  createPhysicsWorld,
  PhysicsError,
  polygon,
  restore,
  type Shape,
  segment,
  setShape,
  shapeAt,
  snapshot,
  spawn,
  spawnMany,
  stateHash,
} from '../../index.ts';

const codeOf = (make: () => unknown) => {
  try {
    make();
  } catch (error) {
    return error instanceof PhysicsError ? error.code : error;
  }
  return 'no error';
};

describe('area and moment of inertia', () => {
  const expectMass = (shape: Shape, area: number, inertiaPerMass: number) => {
    expect(shape.area / area).toBeCloseTo(1, 13);
    expect(shape.inertiaPerMass / inertiaPerMass).toBeCloseTo(1, 12);
  };

  test('of a disc are π r² and r²/2', () => {
    expectMass(circle(0.3), Math.PI * 0.09, 0.045);
  });

  test('of a box are w h and (w² + h²)/12', () => {
    expectMass(box(2, 0.5), 1, (4 + 0.25) / 12);
  });

  test('of a rounded box are those of the box without what its corners lack', () => {
    // Each corner lacks a square of side r without a quarter disc. A quarter disc about the corner of the square that
    // is the centre of the arc: area π r²/4, centroid 4 r/(3π) away along each axis, polar moment π r⁴/8.
    const [w, h, r] = [2, 1, 0.2];
    const quarter = (Math.PI * r * r) / 4;
    const [cx, cy] = [w / 2 - r, h / 2 - r];
    const reach = (4 * r) / (3 * Math.PI);
    const square = r ** 4 / 6 + r * r * ((cx + r / 2) ** 2 + (cy + r / 2) ** 2);
    const arc = (Math.PI * r ** 4) / 8 + 2 * quarter * reach * (cx + cy) + quarter * (cx * cx + cy * cy);
    const area = w * h - 4 * (r * r - quarter);
    const polar = (w * h * (w * w + h * h)) / 12 - 4 * (square - arc);
    expectMass(box(w, h, { rounding: r }), area, polar / area);
  });

  test('of a capsule are those of a rectangle and two half discs', () => {
    const [length, r] = [1.5, 0.25];
    const [rectangle, half] = [2 * r * length, (Math.PI * r * r) / 2];
    // A half disc: centroid 4 r/(3π) from its flat side, polar moment about the middle of that side half r²/2.
    const offset = length / 2;
    const reach = (4 * r) / (3 * Math.PI);
    const polar =
      (rectangle * (length * length + 4 * r * r)) / 12 +
      2 * half * ((r * r) / 2 + offset * offset + 2 * offset * reach);
    expectMass(capsule(length, r), rectangle + 2 * half, polar / (rectangle + 2 * half));
  });

  test('of a triangle are half base times height, and the sum of its squared sides over 36', () => {
    const triangle = polygon([
      { x: 10, y: 5 },
      { x: 13, y: 5 },
      { x: 10, y: 9 },
    ]);
    expectMass(triangle, 6, (9 + 16 + 25) / 36);
    expect(triangle.centre.x).toBeCloseTo(11, 12);
    expect(triangle.centre.y).toBeCloseTo(19 / 3, 12);
  });

  test('of a thin segment are 0 and l²/12', () => {
    const { area, inertiaPerMass, centre } = segment({ x: 1 }, { x: 4, y: 4 });
    expect([area, centre]).toEqual([0, { x: 2.5, y: 2 }]);
    expect(inertiaPerMass).toBeCloseTo(25 / 12, 12);
  });

  test('of a rounded polygon tend to those of a disc as it shrinks inside its rounding', () => {
    const { area, inertiaPerMass } = polygon([{ x: 0 }, { x: 1e-4 }, { y: 1e-4 }], { rounding: 1 });
    // Perimeter times rounding and the triangle are all that is added: 3.4e-4 m² of 3.14.
    expect(area).toBeCloseTo(Math.PI + (2 + Math.SQRT2) * 1e-4 + 0.5e-8, 12);
    expect(inertiaPerMass).toBeCloseTo(0.5, 3);
  });

  test('do not depend on where and which way round the corners are given', () => {
    const points = [
      { x: 0, y: 0 },
      { x: 2, y: 0 },
      { x: 2.5, y: 1 },
      { x: 1, y: 2 },
      { x: -0.5, y: 1 },
    ];
    const one = polygon(points, { rounding: 0.1 });
    const far = polygon(
      [...points].reverse().map(({ x, y }) => ({ x: x + 1000, y: y - 500 })),
      { rounding: 0.1 },
    );
    expect(far.area).toBeCloseTo(one.area, 10);
    expect(far.inertiaPerMass).toBeCloseTo(one.inertiaPerMass, 9);
    expect(far.centre.x - one.centre.x).toBeCloseTo(1000, 10);
    expect(far.extent).toBeCloseTo(one.extent, 10);
  });
});

test('extents are the greatest and the least distance of the surface from the centroid', () => {
  const extents = ({ extent, minExtent }: Shape) => [extent, minExtent];
  expect(extents(circle(2))).toEqual([2, 2]);
  expect(extents(box(6, 8))).toEqual([5, 3]);
  expect(extents(capsule(2, 0.5))).toEqual([1.5, 0.5]);
  expect(extents(segment({ x: -1 }, { x: 1 }))).toEqual([1, 0]);
});

describe('outlines that are refused', () => {
  const square = [
    { x: 0, y: 0 },
    { x: 1, y: 0 },
    { x: 1, y: 1 },
    { x: 0, y: 1 },
  ];
  const octagon = Array.from({ length: 9 }, (_, i) => ({ x: Math.cos(0.7 * i), y: Math.sin(0.7 * i) }));
  const star = [0, 2, 4, 1, 3].map((i) => ({ x: Math.cos(1.2566 * i), y: Math.sin(1.2566 * i) }));

  test.each<[string, () => unknown, string]>([
    ['too few corners', () => polygon(square.slice(0, 2)), 'E_RANGE'],
    ['too many corners', () => polygon(octagon), 'E_RANGE'],
    ['a concave corner', () => polygon([...square.slice(0, 3), { x: 0.9, y: 0.5 }]), 'E_RANGE'],
    ['a star, whose corners all turn left', () => polygon(star), 'E_RANGE'],
    ['a corner on the line of its neighbours', () => polygon([...square, { x: 0, y: 0.5 }]), 'E_RANGE'],
    ['all corners on a line', () => polygon([{ x: 0 }, { x: 1 }, { x: 2 }]), 'E_RANGE'],
    ['two equal corners', () => polygon([...square, { x: 0, y: 1 }]), 'E_RANGE'],
    ['NaN', () => polygon([{ x: Number.NaN }, ...square]), 'E_NONFINITE'],
    ['huge coordinates', () => polygon([{ x: -1e7 }, ...square]), 'E_RANGE'],
    ['tiny edges', () => polygon(square.map(({ x, y }) => ({ x: x * 1e-6, y: y * 1e-6 }))), 'E_RANGE'],
    ['an axis too many', () => polygon([{ x: 0, z: 1 } as never, ...square]), 'E_RANGE'],
    ['no points', () => polygon(7 as never), 'E_TYPE'],
    ['a width of zero', () => box(0, 1), 'E_RANGE'],
    ['a rounding as large as the box', () => box(1, 1, { rounding: 0.5 }), 'E_RANGE'],
    ['a negative radius', () => circle(-1), 'E_RANGE'],
    ['a capsule without length', () => capsule(0, 1), 'E_RANGE'],
    ['ends that coincide', () => segment({ x: 1 }, { x: 1 }), 'E_RANGE'],
  ])('%s', (_, make, code) => {
    expect(codeOf(make)).toBe(code);
  });

  test('by an error that names the corner', () => {
    expect(() => polygon([...square.slice(0, 3), { x: 0.9, y: 0.5 }])).toThrow(/inward at corner 3\. .*decompose/);
  });
});

describe('a body with a shape', () => {
  test('gets radius, mass, inertia and what turning needs', () => {
    const world = createPhysicsWorld();
    const body = spawn(world, { position: { x: 1 }, collider: { shape: box(2, 1), density: 3, friction: 0.6 } });
    const { Collider, Mass, Inertia } = world.components;
    expect(Mass.value[body]).toBeCloseTo(6, 12);
    expect(Inertia.value[body]).toBeCloseTo((6 * 5) / 12, 12);
    expect(Collider.radius[body]).toBeCloseTo(Math.sqrt(1.25), 12);
    expect(shapeAt(world, Collider.shape[body])).toEqual(box(2, 1));
    expect([Collider.layers[body], Collider.mask[body]]).toEqual([1, 0xffffffff]);
  });

  test('keeps the mass and inertia it is given, and scales the inertia to a given mass', () => {
    const world = createPhysicsWorld();
    const { Mass, Inertia } = world.components;
    const shape = box(1, 1);
    const given = spawn(world, { position: {}, mass: 5, inertia: Infinity, collider: { shape, density: 1 } });
    const scaled = spawn(world, { position: {}, mass: { value: 12 }, collider: { shape } });
    const still = spawn(world, { position: {}, collider: { shape } });
    expect([Mass.value[given], Inertia.value[given]]).toEqual([5, 0]);
    expect(Inertia.value[scaled]).toBeCloseTo(2, 12);
    expect([Mass.value[still], Inertia.value[still]]).toEqual([0, 0]);
  });

  test('shares the record of an equal shape, and a disc needs none', () => {
    const world = createPhysicsWorld({ precision: 'f32' });
    const { Collider } = world.components;
    const shapes = [box(1, 2), capsule(1, 0.5), box(1, 2), circle(0.25), box(1, 2, { rounding: 0.1 })];
    const ids = shapes.map((shape) => spawn(world, { position: {}, collider: { shape } }));
    expect(ids.map((id) => Collider.shape[id])).toEqual([1, 2, 1, 0, 3]);
    expect(Collider.radius[ids[3]]).toBe(0.25);
  });

  test('is made in bulk from one shape, with masses of its own each', () => {
    const world = createPhysicsWorld();
    const { Collider, Inertia } = world.components;
    const ids = spawnMany(world, 2, { position: { x: [0, 5] }, mass: [1, 2], collider: { shape: box(1, 1) } });
    expect([...ids].map((id) => Collider.shape[id])).toEqual([1, 1]);
    expect(Inertia.value[ids[1]] / Inertia.value[ids[0]]).toBe(2);
  });

  test('changes it, and an equal shape has the index that it had', () => {
    const world = createPhysicsWorld();
    const { Collider } = world.components;
    const body = spawn(world, { position: {}, collider: 1 });
    for (let i = 1; i <= 100; i++) setShape(world, body, box(i, 1));
    expect([Collider.shape[body], Collider.radius[body]]).toEqual([100, box(100, 1).extent]);
    setShape(world, body, box(1, 1));
    expect(Collider.shape[body]).toBe(1);
  });

  test('comes back with a snapshot, and counts in the hash', () => {
    const world = createPhysicsWorld();
    const before = stateHash(world);
    const taken = snapshot(world);
    const body = spawn(world, { position: {}, collider: { shape: box(1, 2) } });
    const one = stateHash(world);
    restore(world, taken);
    expect(stateHash(world)).toBe(before);
    expect(spawn(world, { position: {}, collider: { shape: box(1, 2) } })).toBe(body);
    expect(stateHash(world)).toBe(one);
    restore(world, taken);
    const extents = box(2, 1).extent;
    spawn(world, { position: {}, collider: { shape: box(2, 1) } });
    expect(world.components.Collider.radius[body]).toBe(extents);
    expect(stateHash(world)).not.toBe(one);
  });

  test('is refused, with the world unchanged, where shape, density or world do not fit', () => {
    const world = createPhysicsWorld();
    const space = createPhysicsWorld({ dimensions: 3 });
    const before = stateHash(world);
    const shape = box(1, 1);
    expect(codeOf(() => spawn(space, { position: {}, collider: { shape } }))).toBe('E_RANGE');
    expect(codeOf(() => spawn(world, { position: {}, collider: { shape: 4 } }))).toBe('E_RANGE');
    expect(codeOf(() => spawn(world, { position: {}, collider: { shape: 'box' as never } }))).toBe('E_TYPE');
    expect(codeOf(() => spawn(world, { position: {}, collider: { shape, radius: 2 } }))).toBe('E_RANGE');
    expect(codeOf(() => spawn(world, { position: {}, collider: { shape, density: 0 } }))).toBe('E_RANGE');
    expect(codeOf(() => spawn(world, { position: {}, collider: { shape, friction: -1 } }))).toBe('E_RANGE');
    const line = segment({}, { x: 1 });
    expect(codeOf(() => spawn(world, { position: {}, collider: { shape: line, density: 1 } }))).toBe('E_RANGE');
    expect(codeOf(() => setShape(world, 3, shape))).toBe('E_STALE');
    expect(stateHash(world)).toBe(before);
  });

  test('is not set of a body without a collider, which is not stale', () => {
    const world = createPhysicsWorld();
    const point = spawn(world, { position: {}, mass: 1 });
    expect(codeOf(() => setShape(world, point, box(1, 1)))).toBe('E_RANGE');
    expect(() => setShape(world, point, box(1, 1))).toThrow(`body ${point} has no collider`);
    addComponent(world, point, set(world.components.Collider, { radius: 0.5 }));
    setShape(world, point, box(1, 3));
    expect(shapeAt(world, world.components.Collider.shape[point])).toMatchObject({ area: 3 });
  });

  test('may take density with a radius, in 3D as a ball', () => {
    const space = createPhysicsWorld({ dimensions: 3 });
    const { Mass, Inertia } = space.components;
    const ball = spawn(space, { position: {}, collider: { radius: 2, density: 3 } });
    expect(Mass.value[ball]).toBeCloseTo(32 * Math.PI, 10);
    expect(Inertia.value[ball] / Mass.value[ball]).toBeCloseTo(1.6, 12);
  });
});
