// Joints whose ends are metres apart when they are made, or whose columns ask for it: they come together in steps, and give nothing to
// what their bodies touch.
import { box, createJoint, destroyWorld, distance, energy, revolute, softStep, spawn, weld } from '@principia/physics';
import { describe, expect, test } from 'vitest';
import { rigidWorld, run } from '../../../../test/support/rigid-world.ts';

const awake = softStep({ sleepTime: 0 });

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  /** A row of six boxes of 1 kg that touch, in free space, and a block of 18 kg aside. */
  function rowOfBoxes() {
    const world = rigidWorld({ precision, integrator: awake, forces: [] });
    const shape = box(1, 1);
    const row = [0, 1, 2, 3, 4, 5].map((x) =>
      spawn(world, { position: { x }, velocity: {}, collider: { shape, density: 1 } }),
    );
    const block = spawn(world, { position: { x: 9, y: 8 }, velocity: {}, collider: { shape, density: 18 } });
    run(world, 0.1);
    return { world, row, block };
  }

  test.each([
    ['a rope', (a: number, b: number) => distance({ a, b, limits: { upper: 3 } })],
    ['a rod', (a: number, b: number) => distance({ a, b, length: 3 })],
    ['a hinge', (a: number, b: number) => revolute({ a, b, anchor: { x: 3 } })],
    ['a weld', (a: number, b: number) => weld({ a, b, anchor: { x: 3 } })],
  ])('%s whose end is carried away by metres gives a row of boxes at most 1 J for each kilogram', (_, make) => {
    const { world, row, block } = rowOfBoxes();
    const { x, y } = world.components.Position;
    const [farX, farY] = [x[block], y[block]];
    [x[block], y[block]] = [3, 1];
    createJoint(world, make(row[3], block));
    [x[block], y[block]] = [farX, farY];
    let most = 0;
    for (let i = 0; i < 120; i++) {
      run(world, 1 / 60);
      most = Math.max(most, energy(world).total);
    }
    // The ends approach at 0.1 m times the rate of a joint, 77/s at most: 7.7 m/s between a box and 18 kg. What touches the box gets
    // that for a sub-step: (1/2) 6 kg (7.7 m/s)² is 178 J; most of it is taken back.
    expect(most).toBeLessThan(24);
    destroyWorld(world);
  });

  test('a rope is as short as its column says in the end', () => {
    const { world, row, block } = rowOfBoxes();
    const rope = createJoint(world, distance({ a: row[3], b: block, limits: { upper: 11 } }));
    run(world, 0.1);
    world.components.Joint.upper[rope] = 3;
    run(world, 3);
    const { x, y } = world.components.Position;
    expect(Math.hypot(x[block] - x[row[3]], y[block] - y[row[3]])).toBeLessThan(3.01);
    destroyWorld(world);
  });
});
