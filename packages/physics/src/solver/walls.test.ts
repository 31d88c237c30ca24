// Walls that are no bodies hold rigid bodies: segments, half-planes and boxes.
import {
  type BodyInput,
  box,
  boxWalls,
  capsule,
  contactEvents,
  despawn,
  energy,
  isAsleep,
  polygon,
  replaceBoxWalls,
  restore,
  snapshot,
  spawn,
  stateHash,
  step,
} from '@principia/physics';
import { query } from 'bitecs';
import { describe, expect, it, test } from 'vitest';
import { DT, G, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const roof = polygon([{ x: -0.5 }, { x: 0.5 }, { y: 0.6 }]);
const SHAPES: [string, BodyInput['collider'], number][] = [
  ['a box', { shape: box(1, 0.5) }, 0.25],
  ['a disc', { radius: 0.3 }, 0.3],
  ['a capsule', { shape: capsule(0.6, 0.2) }, 0.2],
  ['a rounded box', { shape: box(1, 0.6, { rounding: 0.1 }) }, 0.3],
  ['a triangle', { shape: roof }, roof.centre.y],
];

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each(SHAPES)('%s rests on a plane, on a segment and in a box, and sleeps', (_, shape, height) => {
    const collider = { ...(shape as object), density: 2, friction: 0.6 };
    for (const wall of ['plane', 'segment', 'box']) {
      const world = rigidWorld({ precision, walls: wall === 'box' ? [boxWalls({ min: { x: -5, y: 0 } })] : [] });
      if (wall === 'plane') spawn(world, { planeWall: {} });
      if (wall === 'segment') spawn(world, { segmentWall: { ax: -5, bx: 5 } });
      const body = spawn(world, { position: { y: height + 0.5 }, collider });
      run(world, 3);
      expect(Math.abs(world.components.Position.y[body] - height)).toBeLessThan(0.005);
      expect(isAsleep(world, body)).toBe(true);
      expect(world.components.Rotation.angle[body]).toBeCloseTo(0, 2);
    }
  });

  it.each(['before', 'after', 'box'])('small discs that fall fast rest on a plane that is made %s them', (made) => {
    const world = rigidWorld({ precision, walls: made === 'box' ? [boxWalls({ min: { y: 0 } })] : [] });
    if (made === 'before') spawn(world, { planeWall: {} });
    const radius = 0.05;
    const discs = Array.from({ length: 20 }, (_, i) =>
      spawn(world, { position: { x: 2 * i - 20, y: 1 + 0.2 * i }, collider: { radius, density: 100 } }),
    );
    if (made === 'after') spawn(world, { planeWall: {} });
    run(world, 3);
    const { Position, Velocity } = world.components;
    for (const disc of discs) {
      expect(Math.abs(Position.y[disc] - radius)).toBeLessThan(0.005);
      expect(Velocity.y[disc]).toBe(0);
    }
  });

  it('a box slides down a plane with g (sin θ - μ cos θ)', () => {
    const angle = 0.4;
    const world = rigidWorld({ precision });
    // The friction of a contact is the geometric mean: √(0.1 · 0.4) = 0.2.
    spawn(world, { planeWall: { nx: -Math.sin(angle), ny: Math.cos(angle), friction: 0.1 } });
    const position = { x: -0.25 * Math.sin(angle), y: 0.25 * Math.cos(angle) };
    const collider = { shape: box(1, 0.5), density: 1, friction: 0.4 };
    const body = spawn(world, { position, rotation: angle, collider });
    run(world, 1);
    const { x, y } = world.components.Velocity;
    const along = -x[body] * Math.cos(angle) - y[body] * Math.sin(angle);
    expect(along).toBeCloseTo(G * (Math.sin(angle) - 0.2 * Math.cos(angle)), 1);
  });

  it('a ball bounces in a box with the restitution of the walls, and keeps its energy at 1', () => {
    const walls = [boxWalls({ min: { x: -2, y: -1 }, max: { x: 2, y: 1 }, restitution: 1 })];
    const world = rigidWorld({ precision, walls, forces: [] });
    const ball = spawn(world, { position: {}, velocity: { x: 5, y: 3.3 }, collider: { radius: 0.2, density: 1 } });
    const before = energy(world).kinetic;
    const { Position } = world.components;
    for (let i = 0; i < 600; i++) {
      step(world, DT);
      expect(Math.abs(Position.x[ball])).toBeLessThan(1.8 + 5 * DT);
      expect(Math.abs(Position.y[ball])).toBeLessThan(0.8 + 3.3 * DT);
    }
    expect(energy(world).kinetic / before).toBeCloseTo(1, 3);
  });

  it('a box without friction of its own takes that of the body', () => {
    const world = rigidWorld({ precision, walls: [boxWalls({ min: { y: 0 } })] });
    const block = spawn(world, {
      position: { y: 0.25 },
      velocity: { x: 4 },
      collider: { shape: box(1, 0.5), density: 1, friction: 0.4 },
    });
    run(world, 3);
    expect(world.components.Position.x[block] / (16 / (2 * 0.4 * G))).toBeCloseTo(1, 1);
  });

  it('nothing fast passes a wall', () => {
    const world = rigidWorld({ precision, forces: [] });
    spawn(world, { segmentWall: { ax: 0, ay: -2, bx: 0, by: 2 } });
    spawn(world, { planeWall: { nx: 1, ny: 0, offset: -20 } });
    const shot = (y: number) =>
      spawn(world, { position: { x: 10, y }, velocity: { x: -2000 }, collider: { radius: 0.1, density: 1 } });
    const [stopped, passed] = [shot(0), shot(5)];
    run(world, 0.5);
    expect(world.components.Position.x[stopped]).toBeGreaterThan(0);
    expect(world.components.Position.x[passed]).toBeGreaterThan(-20);
  });

  it('a wall that is moved carries and wakes, and one that is removed drops what lay on it', () => {
    const world = rigidWorld({ precision });
    const wall = spawn(world, { segmentWall: { ax: -5, bx: 5 } });
    const body = spawn(world, { position: { y: 0.5 }, collider: { shape: box(1, 1), density: 1, friction: 0.6 } });
    run(world, 2);
    expect(isAsleep(world, body)).toBe(true);
    const { SegmentWall, Position } = world.components;
    for (let i = 0; i < 60; i++) {
      SegmentWall.ay[wall] += 0.01;
      SegmentWall.by[wall] += 0.01;
      step(world, DT);
    }
    expect(Position.y[body]).toBeCloseTo(1.1, 1);
    run(world, 2);
    expect(isAsleep(world, body)).toBe(true);
    despawn(world, wall);
    run(world, 1);
    expect(Position.y[body]).toBeLessThan(-2);
  });
});

test('contact events name the wall', () => {
  const world = rigidWorld();
  const floor = spawn(world, { planeWall: {} });
  const ball = spawn(world, { position: { y: 0.5 }, collider: { radius: 0.5, density: 1 } });
  step(world, DT);
  const { begin } = contactEvents(world);
  expect([begin.count, begin.a[0], begin.b[0], begin.ny[0]]).toEqual([1, floor, ball, 1]);
});

test('another box takes the place of a box, and without one nothing holds', () => {
  const world = rigidWorld({ walls: [boxWalls({ min: { y: 0 } })], capacity: 20 });
  const ball = spawn(world, { position: { y: 1 }, collider: { radius: 0.5, density: 1 } });
  run(world, 2);
  const { y } = world.components.Position;
  expect(y[ball]).toBeCloseTo(0.5, 2);
  world.phases.walls[0] = boxWalls({ min: { y: -3 }, max: { y: 10 } });
  run(world, 2);
  expect(y[ball]).toBeCloseTo(-2.5, 2);
  expect(world.internal.counts.PlaneWall).toBe(2);
  world.phases.walls.length = 0;
  run(world, 1);
  expect(y[ball]).toBeLessThan(-5);
  expect(world.internal.counts.PlaneWall).toBe(0);
});

test('a heap in a box comes back from a snapshot to the bit', () => {
  const world = rigidWorld({ walls: [boxWalls({ min: { x: -2, y: 0 }, max: { x: 2 } })], precision: 'f32' });
  for (let i = 0; i < 40; i++) {
    const collider = { shape: box(0.4, 0.3), density: 1, friction: 0.5 };
    spawn(world, { position: { x: 0.7 * ((i % 5) - 2), y: 0.5 + 0.5 * i }, rotation: i, collider });
  }
  run(world, 2);
  const kept = snapshot(world);
  run(world, 2);
  const hash = stateHash(world);
  restore(world, kept);
  run(world, 2);
  expect(stateHash(world)).toBe(hash);
  for (let id = 1; id <= 40; id++) expect(Math.abs(world.components.Position.x[id])).toBeLessThan(2);
});

test('what is a wall and a body at once is refused, and a wall of numbers that are not finite is reported and left out', () => {
  const world = rigidWorld();
  const both = spawn(world, { position: {}, collider: 1, planeWall: {} });
  expect(() => step(world, DT)).toThrow(
    /has PlaneWall and Position, so that it is two things at once.*entity of its own/,
  );
  despawn(world, both);
  const two = spawn(world, { segmentWall: { bx: 1 }, planeWall: {} });
  expect(() => step(world, DT)).toThrow(/two things/);
  despawn(world, two);
  const wall = spawn(world, { segmentWall: { ax: -5, bx: 5 } });
  const ball = spawn(world, { position: { y: 0.5 }, collider: { radius: 0.5, density: 1 } });
  run(world, 0.5);
  world.components.SegmentWall.ay[wall] = Number.NaN;
  run(world, 0.5);
  expect(world.faults.faults).toMatchObject([{ code: 'E_NONFINITE', entity: wall, field: 'SegmentWall.ay' }]);
  expect(world.components.Position.y[ball]).toBeLessThan(0);
  expect(Number.isFinite(world.components.Position.y[ball])).toBe(true);
  const full = rigidWorld({ capacity: 2, walls: [boxWalls({ min: { x: -1, y: -1 }, max: { x: 1, y: 1 } })] });
  expect(() => step(full, DT)).toThrow(expect.objectContaining({ code: 'E_CAPACITY' }));
});

test('a box makes a wall anew that was despawned, and leaves the wall alone that took its id', () => {
  const world = rigidWorld({ walls: [boxWalls({ min: { x: -5, y: 0 } })], capacity: 20 });
  const ball = spawn(world, { position: { y: 0.5 }, collider: { radius: 0.5, density: 1 } });
  run(world, 1);
  const { PlaneWall, Position } = world.components;
  const floor = [...query(world, [PlaneWall])].find((id) => PlaneWall.ny[id] === 1) as number;
  despawn(world, floor);
  const mine = spawn(world, { planeWall: { nx: 1, ny: 0, offset: -100 } });
  expect(mine).toBe(floor);
  const taken = snapshot(world);
  const hashes = [0, 1].map(() => {
    restore(world, taken);
    run(world, 1);
    expect(Math.abs(Position.y[ball] - 0.5)).toBeLessThan(0.006);
    replaceBoxWalls(world, { min: { x: -6, y: 0 } });
    step(world, DT);
    expect(query(world, [PlaneWall])).toHaveLength(3);
    expect(PlaneWall.offset[mine]).toBe(-100);
    return stateHash(world);
  });
  expect(hashes[0]).toBe(hashes[1]);
});
