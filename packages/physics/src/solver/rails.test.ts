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
    // 15 % for what is lost where several segments are met at once, and four steps: of one that begins in the air the rest is lost.
    expect(steps * DT).toBeLessThan(way / (0.85 * slowest) + 4 * DT);
    expect(Math.hypot(Velocity.x[ball], Velocity.y[ball])).toBeGreaterThan(0.85 * slowest);
    expect(Math.hypot(Velocity.x[ball], Velocity.y[ball])).toBeLessThan(1.001 * speed);
  },
);
