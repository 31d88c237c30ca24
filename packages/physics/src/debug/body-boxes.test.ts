import { bodyBoxes, box, spawn, wake } from '@principia/physics';
import { expect, it } from 'vitest';
import { rigidWorld, run } from '../../../../test/support/rigid-world.ts';

it.each(['f32', 'f64'] as const)(
  'the boxes of bodies hold their shapes and a margin, and tell who sleeps, %s',
  (precision) => {
    const world = rigidWorld({ precision });
    const floor = spawn(world, { position: { y: -0.5 }, collider: { shape: box(20, 1), friction: 0.6 } });
    const ghost = spawn(world, { position: { x: 9 } });
    const crate = spawn(world, { position: { x: 3, y: 0.5 }, collider: { shape: box(1, 1), density: 2 } });
    const list = bodyBoxes(world);
    expect(list.count).toBe(0);
    run(world, 1);
    expect(bodyBoxes(world, list)).toBe(list);
    expect(list.body.slice(0, list.count)).toEqual([floor, crate]);
    expect(list.body).not.toContain(ghost);
    // The margin is the smaller of 5 cm and an eighth of the extent.
    const margin = Math.min(0.05, Math.SQRT1_2 / 8);
    for (const [side, edge] of [
      [list.minX[1], 2.5 - margin],
      [list.maxX[1], 3.5 + margin],
      [list.minY[1], -margin],
      [list.maxY[1], 1 + margin],
    ]) {
      expect(Math.abs(side - edge)).toBeLessThan(0.005);
    }
    expect(list.asleep).toEqual([false, true]);
    wake(world, crate);
    run(world, 1 / 60);
    expect(bodyBoxes(world, list).asleep[1]).toBe(false);
    expect(() => bodyBoxes(world, {} as never)).toThrow(/E_TYPE.*a list made by bodyBoxes/);
  },
);
