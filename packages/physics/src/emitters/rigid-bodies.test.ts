// Among rigid bodies a particle is a disc from its birth to its end. Before and after, its entity touches nothing.
import {
  aliveCount,
  bodyBoxes,
  burst,
  contactPoints,
  createEmitter,
  type EmitterOptions,
  isAsleep,
  overlapShape,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { DT, G, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';
import { circle } from '../collision/shapes/2d/circle.ts';

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  function withPool(options: Partial<EmitterOptions> = {}) {
    const world = rigidWorld({ precision });
    const pool = createEmitter(world, { capacity: 20, speed: 0, collider: { radius: 0.1 }, ...options });
    return { world, pool, ...world.components };
  }

  test('a body falls freely past particles that are not born', () => {
    const { world, Position, Velocity } = withPool();
    const stone = spawn(world, { position: { y: 1 }, mass: 1, collider: { radius: 0.3 } });
    const steps = 60;
    for (let i = 0; i < steps; i++) step(world, DT);
    const time = steps * DT;
    // To first order of sub-steps of DT / 4, whose drop differs by g t DT / 8.
    expect(Position.y[stone]).toBeCloseTo(1 - (G * time * time) / 2, 1);
    expect(Velocity.y[stone]).toBeCloseTo(-G * time, 4);
    expect(bodyBoxes(world).body).toEqual([stone]);
  });

  test('a bullet flies through particles that are not born, and through one that has ended', () => {
    const { world, pool, Position } = withPool({ lifetime: 0.1, position: { x: 2, y: 5 } });
    burst(pool, 1);
    run(world, 0.3);
    expect(aliveCount(pool)).toBe(0);
    const ended = [...pool.ids].find((id) => Position.x[id] === 2) ?? 0;
    const y = Position.y[ended];
    const bullet = spawn(world, {
      position: { y },
      velocity: { x: 400 },
      mass: 1,
      collider: { radius: 0.02, bullet: 1 },
    });
    step(world, DT);
    expect(Position.x[bullet]).toBeCloseTo(400 * DT, 4);
    expect(overlapShape(world, circle(0.2), { x: 2, y })).toEqual([]);
  });

  test('a body that sleeps on a particle wakes when that ends, and falls to the ground', () => {
    const { world, pool, Position } = withPool({ lifetime: 3, position: { y: 0.1 } });
    spawn(world, { planeWall: {} });
    burst(pool, 1);
    step(world, DT);
    const ball = spawn(world, { position: { y: 0.4 }, mass: 1, collider: { radius: 0.2 } });
    run(world, 2.5);
    expect(isAsleep(world, ball)).toBe(true);
    expect(Math.abs(Position.y[ball] - 0.4)).toBeLessThan(2 * SLOP);
    run(world, 3);
    expect(aliveCount(pool)).toBe(0);
    expect(Math.abs(Position.y[ball] - 0.2)).toBeLessThan(SLOP);
    const { count, a, b } = contactPoints(world);
    expect(Array.from({ length: count }, (_, i) => [a[i], b[i]]).flat()).not.toContain(pool.ids[0]);
  });

  test('particles that come and go on the ground, and on each other, stay finite', () => {
    const { world } = withPool({ capacity: 50, rate: 60, lifetime: [0.05, 0.12], position: { y: 0.1 } });
    spawn(world, { planeWall: {} });
    run(world, 20);
    expect(world.faults.faults).toEqual([]);
  });
});
