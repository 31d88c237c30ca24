// What stands on a lift goes with it.
import { box, circle, contactEvents, type Shape, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, SLOP } from '../../../../test/support/rigid-world.ts';

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([
    ['disc', undefined, 1],
    ['disc', undefined, 3],
    ['disc', undefined, 8],
    ['circle of the pool', circle(0.2), 3],
    ['box', box(0.4, 0.4), 5],
  ] as const)('a %s stays on it, in touch', (_, shape: Shape | undefined, speed) => {
    const world = rigidWorld({ precision });
    const { y } = world.components.Position;
    const plate = { shape: box(4, 0.2), density: 1 };
    const lift = spawn(world, { position: {}, velocity: { y: speed }, kinematic: {}, collider: plate });
    const collider = { ...(shape === undefined ? { radius: 0.2 } : { shape }), density: 10 };
    const id = spawn(world, { position: { y: 0.3 }, velocity: { y: speed }, collider });
    let [begins, ends] = [0, 0];
    for (let k = 0; k < 180; k++) {
      step(world, DT);
      begins += contactEvents(world).begin.count;
      ends += contactEvents(world).end.count;
      expect(Math.abs(y[id] - y[lift] - 0.3)).toBeLessThan(SLOP);
    }
    expect([begins, ends]).toEqual([1, 0]);
  });
});
