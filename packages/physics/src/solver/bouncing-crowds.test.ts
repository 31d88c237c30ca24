// Bodies with restitution that were put in one place separate without bouncing, and do not pass through a plane.
import { box, capsule, contactEvents, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

/** Default of `softStep({ contactSpeed })`, m/s. */
const PUSHED = 3;

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([
    [100, 0.5, 1],
    [100, 1, 1],
    [20, 0.5, 1000],
    [20, 1, 1000],
  ])(
    '%i boxes in one place with a restitution of %f and masses of 1 : %i gain no speed',
    (count, restitution, ratio) => {
      const world = rigidWorld({ precision });
      spawn(world, { planeWall: { restitution } });
      const collider = { shape: box(0.5, 0.4), restitution, friction: 0.5 };
      const ids = Array.from({ length: count }, (_, i) => {
        return spawn(world, { position: { y: 1 }, collider: { ...collider, density: i % 2 === 0 ? 10 * ratio : 10 } });
      });
      const { Velocity } = world.components;
      let fastest = 0;
      for (let i = 0; i < 200; i++) {
        step(world, DT);
        for (const id of ids) fastest = Math.max(fastest, Math.hypot(Velocity.x[id], Velocity.y[id]));
      }
      // What falls from 0.8 m and is pushed out of another at the same time.
      expect(fastest).toBeLessThan(Math.sqrt(2 * G * 0.8) + PUSHED);
    },
  );

  it('a plane keeps its contacts where there is no room for those of all bodies', () => {
    const world = rigidWorld({ precision, capacity: 400 });
    spawn(world, { planeWall: {} });
    const shapes = [capsule(0.4, 0.15), box(0.5, 0.4), box(0.5, 0.4)];
    const ids = Array.from({ length: 200 }, (_, i) => {
      return spawn(world, { position: { y: 1 }, collider: { shape: shapes[i % 3], density: 10, friction: 0.5 } });
    });
    const { Position } = world.components;
    let lowest = 0;
    for (let i = 0; i < 300; i++) {
      step(world, DT);
      for (const id of ids) lowest = Math.min(lowest, Position.y[id]);
    }
    expect(contactEvents(world).droppedCount).toBeGreaterThan(0);
    // No capsule, the longest of them, has both of its ends below the plane: what loses its contact falls for seconds.
    expect(lowest).toBeGreaterThan(-0.35);
  });
});
