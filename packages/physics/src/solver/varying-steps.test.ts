// Steps of different lengths: what contacts and joints keep from one step for the next goes with its length.
import { box, createJoint, isAsleep, revolute, spawn, step, weld } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { rigidWorld, SLOP } from '../../../../test/support/rigid-world.ts';

const alternating = (i: number) => (i % 2 === 0 ? 1 / 60 : 1 / 120);

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it('a tower of ten boxes stands and falls asleep where steps of 1/60 s and 1/120 s alternate', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.6 } });
    const collider = { shape: box(1, 1), density: 10, friction: 0.6 };
    const ids = Array.from({ length: 10 }, (_, i) => spawn(world, { position: { y: 0.5 + i }, collider }));
    for (let i = 0; i < 1500; i++) step(world, alternating(i));
    const { Position } = world.components;
    for (const id of ids) {
      expect(Math.abs(Position.x[id])).toBeLessThan(0.02);
      expect(isAsleep(world, id)).toBe(true);
    }
  });

  it('a welded arm that carries ten times its mass does not shake', () => {
    const world = rigidWorld({ precision });
    const arm = spawn(world, { position: { x: 0.5 }, collider: { shape: box(1, 0.1), density: 100 } });
    const load = spawn(world, { position: { x: 1, y: -0.5 }, mass: 100, inertia: 10, collider: { radius: 0.2 } });
    createJoint(world, weld({ b: arm, anchor: {} }));
    createJoint(world, revolute({ a: arm, b: load, anchor: { x: 1 } }));
    const { Position } = world.components;
    for (let i = 0; i < 300; i++) step(world, alternating(i));
    let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
    for (let i = 0; i < 100; i++) {
      step(world, alternating(i));
      low = Math.min(low, Position.y[load]);
      high = Math.max(high, Position.y[load]);
    }
    expect(high - low).toBeLessThan(SLOP / 10);
    expect(Math.abs(high + 0.5)).toBeLessThan(SLOP);
  });
});
