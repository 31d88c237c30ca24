// Balls on curved rails: a chain of segments that are shorter than what a ball moves by in a step.
import { createPhysicsWorld, rigidBodies, spawn, spawnChain, step } from '@principia/physics';
import { expect, test } from 'vitest';

const DT = 1 / 60;
const R = 2.5;
const r = 0.135;
const LANE = 30;

/** Straight, half a circle of so many segments, clockwise and from within, and straight again. */
function rail(segments: number) {
  const arc = Array.from({ length: segments + 1 }, (_, i) => {
    const angle = Math.PI - (Math.PI * i) / segments;
    return { x: R * Math.cos(angle), y: R * Math.sin(angle) };
  });
  return [{ x: -R, y: -LANE }, ...arc, { x: R, y: -LANE }];
}

test.each([
  ['f32', 24, 30],
  ['f32', 48, 60],
  ['f32', 192, 30],
  ['f32', 192, 100],
  ['f64', 48, 100],
  ['f64', 192, 60],
] as const)(
  'in %s a ball runs through half a circle of %d segments at %d m/s without friction',
  (precision, n, speed) => {
    const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 300 });
    const { Position, Velocity } = world.components;
    spawnChain(world, rail(n), { friction: 0, restitution: 0 });
    const collider = { radius: r, density: 100, friction: 0, restitution: 0 };
    const ball = spawn(world, { position: { x: -R + r, y: -0.5 }, velocity: { y: speed }, collider });
    let steps = 0;
    for (; steps < 200 && !(Position.x[ball] > 0 && Position.y[ball] < 0); steps++) {
      step(world, DT);
      if (Position.y[ball] > 0) expect(Math.hypot(Position.x[ball], Position.y[ball]) + r).toBeLessThan(R + 0.01);
    }
    // At each corner the part of the velocity that goes into the next segment is lost.
    const slowest = speed * Math.cos(Math.PI / n) ** n;
    const way = 0.5 + Math.PI * (R - r) - Position.y[ball];
    // 1 % for what is lost where several segments are met at once, and four steps: of one that begins in the air the rest is lost.
    expect(steps * DT).toBeLessThan(way / (0.99 * slowest) + 4 * DT);
    expect(Math.hypot(Velocity.x[ball], Velocity.y[ball])).toBeGreaterThan(0.99 * slowest);
    expect(Math.hypot(Velocity.x[ball], Velocity.y[ball])).toBeLessThan(1.001 * speed);
  },
);

test.each(['f32', 'f64'] as const)(
  'in %s a ball that rolls on a half-plane into the wedge below a falling ceiling leaves it no faster than it came',
  (precision) => {
    for (const speed of [4, 10, 40, 80]) {
      const world = createPhysicsWorld({ preset: rigidBodies, precision, capacity: 10 });
      spawn(world, { planeWall: {} });
      spawn(world, { segmentWall: { ax: 5, ay: 0.5, bx: 8, by: 0.15 } });
      const ball = spawn(world, { position: { y: 0.1 }, velocity: { x: speed }, mass: 1, collider: { radius: 0.1 } });
      const { Position, Velocity } = world.components;
      for (let i = 0; i < 150; i++) step(world, DT);
      expect(world.faults.faults).toEqual([]);
      // It fits in as far as x = 7.5 m, give or take the slop of 5 mm in a slope of 0.35 / 3.
      expect(Position.x[ball]).toBeLessThan(7.5 + (0.005 * 3) / 0.35);
      expect(Position.y[ball]).toBeGreaterThan(0.1 - 0.005);
      expect(Math.hypot(Velocity.x[ball], Velocity.y[ball])).toBeLessThan(speed);
    }
  },
);
