// Bodies that were put in one place part, and none of them leaves much faster than overlap is pushed out.
import { type BodyInput, box, capsule, circle, momentum, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

const COUNT = 100;
/** By default overlap is pushed out at 3 m/s; those outside have the pushes of some ten layers within. */
const FASTEST = 25;

describe.each(['f32', 'f64'] as const)('in %s a hundred', (precision) => {
  it.each<[string, NonNullable<BodyInput['collider']>, number]>([
    ['boxes', { shape: box(1, 1) }, FASTEST],
    ['discs', { radius: 0.5 }, FASTEST],
    ['rounded boxes', { shape: box(1, 1, { rounding: 0.1 }) }, FASTEST],
    // All of them lie side by side, so that they part in a column of a hundred layers.
    ['capsules', { shape: capsule(0.6, 0.2) }, 4 * FASTEST],
  ])('%s in one place part within two seconds', (_, shape, fastest) => {
    for (const falls of [false, true]) {
      const world = rigidWorld({ precision, ...(falls ? {} : { forces: [] }) });
      if (falls) spawn(world, { position: { y: -1 }, collider: { shape: box(900, 2), friction: 0.6 } });
      const collider = { ...(shape as object), density: 1, friction: 0.6 };
      const ids = Array.from({ length: COUNT }, () => spawn(world, { position: { x: 3, y: 0.5 }, collider }));
      const { Position, Velocity, AngularVelocity } = world.components;
      for (let i = 0; i < 120; i++) {
        step(world, DT);
        for (const id of ids) {
          expect(Math.hypot(Velocity.x[id], Velocity.y[id])).toBeLessThan(fastest);
          expect(Number.isFinite(AngularVelocity.z[id])).toBe(true);
        }
      }
      // The narrowest of these shapes is 0.4 m across.
      const between = (a: number, b: number) =>
        Math.hypot(Position.x[a] - Position.x[b], Position.y[a] - Position.y[b]);
      for (const a of ids) for (const b of ids) if (a < b) expect(between(a, b)).toBeGreaterThan(0.35);
      if (!falls) expect(Math.abs(momentum(world).x)).toBeLessThan(COUNT * (precision === 'f32' ? 1e-3 : 1e-10));
    }
  });

  it('circles in one place part in every direction', () => {
    const world = rigidWorld({ precision, forces: [] });
    const ids = Array.from({ length: COUNT }, () =>
      spawn(world, { position: {}, collider: { shape: circle(0.5), density: 1 } }),
    );
    for (let i = 0; i < 120; i++) step(world, DT);
    const { Position } = world.components;
    const quadrants = ids.map((id) => (Position.x[id] > 0 ? 1 : 0) + (Position.y[id] > 0 ? 2 : 0));
    for (let q = 0; q < 4; q++) expect(quadrants.filter((each) => each === q).length).toBeGreaterThan(COUNT / 8);
  });
});
