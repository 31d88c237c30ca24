/** Shapes that are none, rays that lead nowhere, and bodies too fast for a wall. */
import {
  box,
  capsule,
  createPhysicsWorld,
  nearestPoint,
  type PhysicsWorld,
  polygon,
  rayCast,
  rigidBodies,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { refusal } from '../support/worlds.ts';

const rigidWorld = (precision: 'f32' | 'f64' = 'f64') =>
  createPhysicsWorld({ preset: rigidBodies, capacity: 50, precision });

const SQUARE = [
  { x: 0, y: 0 },
  { x: 1, y: 0 },
  { x: 1, y: 1 },
  { x: 0, y: 1 },
];

describe('shapes', () => {
  it('33 shapes smaller than a hundredth of a millimetre are refused', () => {
    for (const make of [() => box(1e-6, 1), () => capsule(1, 1e-7)]) expect(refusal(make).code).toBe('E_RANGE');
  });

  it('34 a box of no or negative width is refused', () => {
    for (const width of [0, -1, Number.NaN]) expect(refusal(() => box(width, 1))).toBeDefined();
  });

  it('35 a polygon of 0, 1 or 2 points is refused, with their number', () => {
    for (const count of [0, 1, 2]) {
      expect(refusal(() => polygon(SQUARE.slice(0, count))).message).toContain(`${count}`);
    }
  });

  it('36 collinear and duplicate points are refused', () => {
    const line = [0, 1, 2].map((x) => ({ x, y: x }));
    const twice = [SQUARE[0], SQUARE[0], SQUARE[1], SQUARE[2]];
    for (const points of [line, twice]) expect(refusal(() => polygon(points)).code).toBe('E_RANGE');
  });

  it('37 a corner of NaN is refused', () => {
    expect(refusal(() => polygon([...SQUARE.slice(0, 3), { x: Number.NaN, y: 1 }])).code).toBe('E_NONFINITE');
  });

  it('38 a clockwise outline is accepted and reversed', () => {
    expect(polygon([...SQUARE].reverse()).area).toBeCloseTo(1, 12);
  });

  it('39 concave and self-crossing outlines are refused', () => {
    const dart = [...SQUARE.slice(0, 3), { x: 0.9, y: 0.2 }];
    const bowTie = [SQUARE[0], SQUARE[2], SQUARE[1], SQUARE[3]];
    for (const points of [dart, bowTie]) expect(refusal(() => polygon(points)).code).toBe('E_RANGE');
  });

  it('40 more than eight corners are refused, with the number that is allowed', () => {
    const round = Array.from({ length: 9 }, (_, i) => ({ x: Math.cos(0.7 * i), y: Math.sin(0.7 * i) }));
    expect(refusal(() => polygon(round)).message).toContain('8');
  });
});

/** A world with one box of 1 m about (5, 0). */
function withBox(): PhysicsWorld {
  const world = rigidWorld();
  spawn(world, { position: { x: 5 }, collider: { shape: box(1, 1) } });
  return world;
}

describe('queries', () => {
  it('71 a ray without length meets nothing beside a body, or is refused', () => {
    expect(rayCast(withBox(), { x: 0, y: 0 }, { x: 0, y: 0 })).toBeUndefined();
  });

  it.each([Number.NaN, Infinity])('72 a ray to %d is refused', (x) => {
    const world = withBox();
    expect(refusal(() => rayCast(world, { x: 0, y: 0 }, { x, y: 0 })).code).toBe('E_NONFINITE');
    expect(refusal(() => rayCast(world, { x, y: 0 }, { x: 1, y: 0 })).code).toBe('E_NONFINITE');
  });

  it('73 a ray from inside a body does not meet that body', () => {
    expect(rayCast(withBox(), { x: 5, y: 0 }, { x: 9, y: 0 })).toBeUndefined();
  });

  it('74 queries see bodies before the first step', () => {
    expect(nearestPoint(withBox(), { x: 0, y: 0 })).toMatchObject({ distance: 4.5, x: 4.5, y: 0 });
  });

  it('75 a query during a step sees the bodies as they are at that moment', () => {
    const world = withBox();
    const seen: (number | undefined)[] = [];
    world.phases.events.push(() => seen.push(nearestPoint(world, { x: 0, y: 0 })?.distance));
    step(world, 1 / 60);
    expect(seen).toEqual([4.5]);
  });
});

describe.each(['f32', 'f64'] as const)('fast bodies in %s', (precision) => {
  it('84 a ball of 2000 m/s is stopped by a wall of 5 cm', () => {
    const world = rigidWorld(precision);
    spawn(world, { position: { x: 20 }, collider: { shape: box(0.05, 10) } });
    const ball = spawn(world, { position: {}, velocity: { x: 2000 }, collider: { radius: 0.1, density: 1 } });
    for (let i = 0; i < 10; i++) step(world, 1 / 60);
    expect(world.components.Position.x[ball]).toBeLessThan(20);
  });

  it('85 a thin rod that spins at 100 rad/s is stopped by a wall', () => {
    const world = rigidWorld(precision);
    const wall = spawn(world, { position: { x: 1.2 }, collider: { shape: box(0.1, 10), restitution: 0 } });
    const rod = spawn(world, {
      position: {},
      rotation: Math.PI / 2,
      velocity: { x: 3 },
      angularVelocity: -100,
      collider: { shape: box(2, 0.05), density: 10 },
    });
    for (let i = 0; i < 60; i++) step(world, 1 / 60);
    // Its centre cannot be further than the near side of the wall.
    expect(world.components.Position.x[rod]).toBeLessThan(world.components.Position.x[wall] - 0.05);
  });
});
