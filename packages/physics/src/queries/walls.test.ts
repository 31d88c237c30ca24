// Rays, casts, overlaps and nearest points of walls, which are no bodies.
import { describe, expect, test } from 'vitest';
import {
  box,
  boxWalls,
  capsule,
  castShape,
  castShapeAll,
  circle,
  contactEvents,
  createPhysicsWorld,
  nearestPoint,
  overlapShape,
  PhysicsError,
  particleContacts,
  rayCast,
  rayCastAll,
  rigidBodies,
  spawn,
  standard,
  step,
  uniformGravity,
  wallContacts,
} from '../index.ts';

const close = (value: number, digits = 10) => expect.closeTo(value, digits);
const PRESETS = { standard, particleContacts, rigidBodies };
/** A cast ends when the surfaces are 0.1 mm apart, met to a quarter. */
const stopsBefore = (distance: number, hit: { fraction: number } | undefined, length: number) => {
  expect((hit?.fraction ?? Number.NaN) * length).toBeLessThan(distance - 0.9e-4);
  expect((hit?.fraction ?? Number.NaN) * length).toBeGreaterThan(distance - 1.3e-4);
};

describe.each(['standard', 'particleContacts', 'rigidBodies'] as const)('in a world with the preset %s', (preset) => {
  const worldOf = (walls: ReturnType<typeof boxWalls>[] = []) =>
    createPhysicsWorld({ preset: PRESETS[preset], capacity: 500, walls });

  test('a ray meets a segment from both sides, at its ends, and neither beside it nor along it', () => {
    const world = worldOf();
    const wall = spawn(world, { segmentWall: { ax: 2, ay: -1, bx: 2, by: 1 } });
    const hit = rayCast(world, { y: -1 }, { x: 4, y: 1 });
    expect(hit).toEqual({ body: wall, isWall: true, fraction: close(0.5), x: close(2), y: close(0), nx: -1, ny: 0 });
    expect(rayCast(world, { x: 4 }, {})).toMatchObject({ fraction: close(0.5), nx: close(1), ny: close(0) });
    expect(rayCast(world, { y: 1 }, { x: 4, y: 1 })).toMatchObject({ x: close(2), y: close(1) });
    expect(rayCast(world, { y: 1.0001 }, { x: 4, y: 1.0001 })).toBeUndefined();
    expect(rayCast(world, { x: 2, y: -3 }, { x: 2, y: 3 })).toBeUndefined();
    expect(rayCast(world, { x: 1.999, y: -3 }, { x: 1.999, y: 3 })).toBeUndefined();
    expect(rayCast(world, {}, { x: 1.999 })).toBeUndefined();
  });

  test('a ray enters a plane from outside alone, and one that runs along it never', () => {
    const world = worldOf();
    // Solid below the line through (0, 1.25) with the normal (-0.6, 0.8).
    const wall = spawn(world, { planeWall: { nx: -3, ny: 4, offset: 1 } });
    const hit = rayCast(world, { y: 4 }, { y: -4 });
    expect(hit).toMatchObject({ body: wall, isWall: true, fraction: close(2.75 / 8), y: close(1.25) });
    expect(hit).toMatchObject({ nx: close(-0.6), ny: close(0.8) });
    expect(rayCast(world, { y: -4 }, { y: 4 })).toBeUndefined();
    expect(rayCast(world, { y: -4 }, { y: -8 })).toBeUndefined();
    expect(rayCast(world, { x: -4, y: -1.75 + 1e-9 }, { x: 4, y: 4.25 + 1e-9 })).toBeUndefined();
    expect(rayCast(world, { x: 0, y: 4 }, { x: 0, y: 1.26 })).toBeUndefined();
  });

  test('casts of capsules, boxes and discs stop before segments and planes', () => {
    const world = worldOf();
    const floor = spawn(world, { planeWall: { offset: -1 } });
    const ledge = spawn(world, { segmentWall: { ax: 3, ay: 1, bx: 5, by: 1 } });
    const upright = castShape(world, capsule(1, 0.25), { y: 3, angle: Math.PI / 2 }, { y: -6 });
    expect(upright).toMatchObject({ body: floor, isWall: true, nx: close(0), ny: close(1), y: close(-1, 3) });
    stopsBefore(3 + 1 - 0.75, upright, 6);
    // A square on a corner is √2/2 of its width high.
    const corner = castShape(world, box(1, 1), { x: -2, y: 3, angle: Math.PI / 4 }, { y: -6 });
    expect(corner).toMatchObject({ body: floor, x: close(-2) });
    stopsBefore(4 - Math.SQRT1_2, corner, 6);
    const onLedge = castShape(world, box(1, 1, { rounding: 0.1 }), { x: 4, y: 3 }, { y: -6 });
    expect(onLedge).toMatchObject({ body: ledge, isWall: true, nx: close(0), ny: close(1) });
    stopsBefore(1.5, onLedge, 6);
    // It meets the end of the ledge with its own side: a disc 0.3 m beside it, 0.4 m before its centre is over it.
    const disc = castShape(world, circle(0.5), { x: 0, y: 1.3 }, { x: 4 });
    expect(disc).toMatchObject({ body: ledge, nx: close(-0.8, 3), ny: close(0.6, 3), x: close(3, 3), y: close(1, 3) });
    expect(castShape(world, circle(0.5), { x: 0, y: 1.51 }, { x: 8 })).toBeUndefined();
    const all = castShapeAll(world, circle(0.5), { x: 4, y: 3 }, { y: -6 });
    expect(all.map(({ body }) => body)).toEqual([ledge, floor]);
    expect(castShape(world, circle(0.5), { y: -0.8 }, { y: 5 })).toMatchObject({ body: floor, fraction: 0 });
  });

  test('overlaps and nearest points of a segment and of a plane are exact', () => {
    const world = worldOf();
    const floor = spawn(world, { planeWall: { nx: 0.6, ny: 0.8, offset: -5 } });
    const ledge = spawn(world, { segmentWall: { ax: 3, ay: 1, bx: 5, by: 1 } });
    expect(overlapShape(world, circle(1), { x: 4, y: 1.99 })).toEqual([ledge]);
    expect(overlapShape(world, circle(1), { x: 4, y: 2.01 })).toEqual([]);
    expect(overlapShape(world, circle(1), { x: -3 + 0.6 * 0.99, y: -4 + 0.8 * 0.99 })).toEqual([floor]);
    expect(overlapShape(world, circle(1), { x: -3 + 0.6 * 1.01, y: -4 + 0.8 * 1.01 })).toEqual([]);
    expect(overlapShape(world, box(40, 0.1), {})).toEqual([floor]);
    expect(overlapShape(world, box(40, 40), {})).toEqual([floor, ledge]);
    expect(nearestPoint(world, { x: 4.5, y: 2 })).toEqual({
      body: ledge,
      isWall: true,
      distance: close(1),
      x: close(4.5),
      y: close(1),
    });
    expect(nearestPoint(world, { x: 8, y: 5 })).toMatchObject({ body: ledge, distance: close(5), x: close(5) });
    // The foot of the origin on the plane.
    expect(nearestPoint(world, {}, { ignore: ledge })).toMatchObject({ body: floor, distance: close(5), x: close(-3) });
    expect(nearestPoint(world, { x: -9, y: -9 })).toMatchObject({ body: floor, distance: 0, x: -9, y: -9 });
    expect(nearestPoint(world, { x: 4, y: 2 }, { maxDistance: 0.99 })).toBeUndefined();
  });

  test('walls of a box are met from inside, before the first step and after', () => {
    const world = worldOf([boxWalls({ min: { x: -4, y: -3 }, max: { x: 4, y: 3 } })]);
    spawn(world, { position: { x: 3.5, y: 2.5 }, velocity: {}, mass: 1, collider: { radius: 0.1 } });
    for (let turn = 0; turn < 2; turn++) {
      const right = rayCast(world, {}, { x: 10 });
      expect(right).toMatchObject({ isWall: true, fraction: close(0.4), x: close(4), nx: -1 });
      // As contact events name it: no entity, but one in a world of rigid bodies that has been stepped.
      expect((right?.body ?? -1) > 0).toBe(preset === 'rigidBodies' && turn === 1);
      expect(rayCastAll(world, {}, { x: 8, y: 12 }).map(({ ny, fraction }) => [ny, fraction])).toEqual([
        [close(-1), close(0.25)],
        [close(0), close(0.5)],
      ]);
      expect(rayCast(world, { x: 10 }, {})).toBeUndefined();
      expect(castShape(world, box(1, 1), {}, { y: -9 })).toMatchObject({ isWall: true, ny: close(1), y: close(-3, 3) });
      expect(nearestPoint(world, { x: -3, y: 1 })).toMatchObject({ isWall: true, distance: close(1), x: -4 });
      const corner = overlapShape(world, circle(1), { x: -3.5, y: -2.5 });
      expect(corner).toHaveLength(preset === 'rigidBodies' && turn === 1 ? 2 : 1);
      step(world, 1 / 60);
    }
  });

  test('a filter leaves walls out, all or one, and masks do not', () => {
    const world = worldOf([boxWalls({ max: { x: 10 } })]);
    const near = spawn(world, { segmentWall: { ax: 2, ay: -1, bx: 2, by: 1 } });
    const far = spawn(world, { segmentWall: { ax: 4, ay: -1, bx: 4, by: 1 } });
    const body = spawn(world, { position: { x: 6 }, collider: { radius: 1, layers: 2 } });
    const met = (filter: object) => rayCastAll(world, {}, { x: 20 }, filter).map(({ body }) => body);
    expect(met({})).toEqual([near, far, body, 0]);
    expect(met({ walls: false })).toEqual([body]);
    expect(met({ ignore: near })).toEqual([far, body, 0]);
    expect(met({ mask: 1 })).toEqual([near, far, 0]);
    expect(rayCast(world, {}, { x: 20 }, { walls: false })).toMatchObject({ body, isWall: false });
    expect(overlapShape(world, box(99, 1), {}, { walls: false })).toEqual([body]);
    expect(nearestPoint(world, { x: 2 }, { walls: false })?.body).toBe(body);
    expect(castShape(world, circle(0.1), {}, { x: 20 }, { walls: false })?.body).toBe(body);
  });

  test('a wall that is not finite or has no length is not seen, and one that is changed is seen where it is now', () => {
    const world = worldOf();
    const wall = spawn(world, { segmentWall: { ax: 2, ay: -1, bx: 2, by: 1 } });
    const plane = spawn(world, { planeWall: { offset: -3 } });
    world.components.SegmentWall.by[wall] = Number.NaN;
    world.components.PlaneWall.ny[plane] = 0;
    expect(rayCastAll(world, {}, { x: 9, y: -9 })).toEqual([]);
    expect(overlapShape(world, box(99, 99), {})).toEqual([]);
    world.components.SegmentWall.by[wall] = -1;
    expect(rayCast(world, { y: -1 }, { x: 9, y: -1 })).toBeUndefined();
    world.components.SegmentWall.by[wall] = 3;
    world.components.PlaneWall.ny[plane] = 2;
    expect(rayCastAll(world, { y: 2 }, { x: 4, y: 2 })).toHaveLength(1);
    expect(rayCast(world, { x: 9 }, { x: 9, y: -9 })).toMatchObject({ body: plane, y: close(-3), ny: 1 });
    expect(() => rayCast(world, { x: Number.NaN }, {})).toThrow(PhysicsError);
    expect(() => rayCast(world, {}, {}, { walls: 1 } as never)).toThrow(expect.objectContaining({ code: 'E_TYPE' }));
  });
});

test('the wall is the one that contact events name', () => {
  for (const preset of ['particleContacts', 'rigidBodies'] as const) {
    const walls = [boxWalls({ min: { x: -4 } })];
    const world = createPhysicsWorld({ preset: PRESETS[preset], capacity: 100, forces: [uniformGravity()], walls });
    const floor = spawn(world, { segmentWall: { ax: -5, bx: 5 } });
    const ball = spawn(world, { position: { y: 0.3 }, velocity: { x: -9 }, collider: { radius: 0.3 }, mass: 1 });
    const named = new Set<number>();
    for (let i = 0; i < 60; i++) {
      step(world, 1 / 60);
      if (preset === 'particleContacts') {
        for (let k = 0; k < wallContacts(world).count; k++) named.add(wallContacts(world).wall[k]);
      } else {
        const { begin } = contactEvents(world);
        for (let k = 0; k < begin.count; k++) named.add(begin.a[k] === ball ? begin.b[k] : begin.a[k]);
      }
    }
    const down = rayCast(world, { x: 1, y: 1 }, { x: 1, y: -1 });
    const left = rayCast(world, { x: 1, y: 1 }, { x: -9, y: 1 });
    expect(down?.body).toBe(floor);
    expect(named).toEqual(new Set([floor, left?.body]));
  }
});

test('among many bodies the trees of a world of rigid bodies change nothing', () => {
  const world = createPhysicsWorld({ preset: rigidBodies, capacity: 1000, precision: 'f32' });
  const wall = spawn(world, { segmentWall: { ax: 2, ay: -1, bx: 2, by: 1 } });
  for (let i = 0; i < 400; i++) spawn(world, { position: { x: i, y: 50 }, collider: { shape: box(0.5, 0.5) } });
  for (let i = 0; i < 3; i++) {
    expect(rayCast(world, {}, { x: 20 })).toMatchObject({ body: wall, x: close(2, 5), nx: -1 });
    expect(nearestPoint(world, { x: 5, y: 5 })).toMatchObject({ body: wall, distance: close(5, 5) });
    expect(nearestPoint(world, { x: 5, y: 45 })?.isWall).toBe(false);
    expect(overlapShape(world, circle(1), { x: 1.5 })).toEqual([wall]);
    step(world, 1 / 60);
  }
});
