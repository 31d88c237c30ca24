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

  // What bears a tower is as stiff in all steps: else it sinks in by another depth in each, and topples or never comes to rest.
  it.each([1 / 60, 1 / 120, 1 / 240])(
    'a tower of twelve boxes stands and falls asleep where steps of 1/30 s and %f s alternate',
    (short) => {
      const world = rigidWorld({ precision });
      spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.6 } });
      const collider = { shape: box(1, 1), density: 500, friction: 0.5 };
      const ids = Array.from({ length: 12 }, (_, i) => spawn(world, { position: { y: 0.5 + i }, collider }));
      for (let i = 0; world.time < 30; i++) step(world, i % 2 === 0 ? short : 1 / 30);
      // A tenth of what would topple it.
      for (const id of ids) {
        expect(Math.abs(world.components.Position.x[id])).toBeLessThan(0.05);
        expect(isAsleep(world, id)).toBe(true);
      }
    },
  );

  // What a long step leaves unsolved, some mm/s, a short one ends by impulses that have nothing to do with its length.
  it.each([1e-8, 1e-6, 1e-4, 1 / 600, 1 / 120])(
    'a tower is not moved by steps of %f s among those of 1/60 s',
    (short) => {
      const world = rigidWorld({ precision });
      spawn(world, { position: { y: -0.5 }, collider: { shape: box(40, 1), friction: 0.6 } });
      const collider = { shape: box(1, 1), density: 10, friction: 0.6 };
      const ids = Array.from({ length: 10 }, (_, i) => {
        return spawn(world, { position: { y: 0.5 + i }, collider, neverSleep: {} });
      });
      const { Position, Velocity } = world.components;
      // As it settles it sways by some millimetres, for seconds.
      for (let i = 0; i < 900; i++) step(world, 1 / 60);
      const before = ids.map((id) => ({ x: Position.x[id], y: Position.y[id] }));
      let fastest = 0;
      for (let i = 0; i < 300; i++) {
        step(world, i % 2 === 0 || i % 7 === 0 ? short : 1 / 60);
        for (const id of ids) fastest = Math.max(fastest, Math.hypot(Velocity.x[id], Velocity.y[id]));
      }
      // A tenth of the speed that gravity gives in a step and contacts take back.
      expect(fastest).toBeLessThan(10 / 60 / 10);
      ids.forEach((id, i) => {
        expect(Math.abs(Position.x[id] - before[i].x)).toBeLessThan(SLOP / 5);
        expect(Math.abs(Position.y[id] - before[i].y)).toBeLessThan(SLOP);
      });
    },
  );

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
