// Hinges with friction, all of which hold: a chain of them between two walls is held in more directions than it has, and friction
// takes energy all the same.
import { box, createJoint, energy, type PhysicsWorld, revolute, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, run } from '../../../../test/support/rigid-world.ts';

type Point = readonly [x: number, y: number];

/** A bar of 20 kg between each two points, of which the first and the last are fixed. All hinges have friction of as many N m. */
function hang(world: PhysicsWorld, points: readonly Point[], friction: number): number[] {
  const bars = points.slice(1).map(([x2, y2], i) => {
    const [x1, y1] = points[i] as Point;
    return spawn(world, {
      position: { x: (x1 + x2) / 2, y: (y1 + y2) / 2 },
      rotation: Math.atan2(y2 - y1, x2 - x1),
      mass: 20,
      collider: { shape: box(0.9, 0.1), friction: 0.6 },
    });
  });
  const motor = friction > 0 ? { motor: { speed: 0, max: friction } } : {};
  for (const [i, [x, y]] of points.entries()) {
    const isFixed = i === 0 || i === bars.length;
    const b = bars[Math.min(i, bars.length - 1)] as number;
    createJoint(world, revolute({ ...(isFixed ? {} : { a: bars[i - 1] as number }), b, anchor: { x, y }, ...motor }));
  }
  return bars;
}

/** Takes steps, and returns by how much the energy grew in one, at most, J. */
function largestGain(world: PhysicsWorld, seconds: number): number {
  let gain = 0;
  let before = energy(world).total;
  for (let i = 0; i < seconds / DT; i++) {
    step(world, DT);
    const { total } = energy(world);
    gain = Math.max(gain, total - before);
    before = total;
  }
  return gain;
}

/** Points of bars of 1 m along a catenary of this span between two points at height 0. */
function catenary(bars: number, span: number): Point[] {
  let [low, high] = [0.1, 100];
  for (let k = 0; k < 100; k++) {
    const c = (low + high) / 2;
    if (2 * c * Math.asinh(bars / 2 / c) > span) high = c;
    else low = c;
  }
  const c = low;
  return Array.from({ length: bars + 1 }, (_, i) => {
    const x = c * Math.asinh((i - bars / 2) / c);
    return [x + span / 2, c * (Math.cosh(x / c) - Math.cosh(span / 2 / c))] as const;
  });
}

describe.each(['f32', 'f64'] as const)('friction in all hinges, in %s', (precision) => {
  // The weight of the bars, 600 N, times the 0.1 mm by which hinges give way.
  const SLACK = 0.06;

  it.each([0, 20, 40, 60, 80, 100, 150, 200])(
    'three bars at rest between two walls stay at rest, with %d N m',
    (friction) => {
      const world = rigidWorld({ precision });
      const y = -Math.sqrt(1 - 0.925 * 0.925);
      const bars = hang(
        world,
        [
          [-1.425, 0],
          [-0.5, y],
          [0.5, y],
          [1.425, 0],
        ],
        friction,
      );
      expect(largestGain(world, 10)).toBeLessThan(SLACK);
      for (const bar of bars) expect(Math.abs(world.components.Velocity.y[bar] as number)).toBeLessThan(1e-4);
    },
  );

  it.each([3, 5, 8, 20])('a crate set down on a bridge of %d planks gives it no energy but its own', (count) => {
    for (const friction of [20, 70, 100, 150]) {
      const world = rigidWorld({ precision });
      const bars = hang(world, catenary(count, 0.95 * count), friction);
      run(world, 3);
      const middle = bars[count >> 1] as number;
      const { x, y } = world.components.Position;
      spawn(world, {
        position: { x: x[middle] as number, y: (y[middle] as number) + 0.3 },
        mass: 20,
        collider: { shape: box(0.4, 0.4), friction: 1 },
      });
      // A tenth of what the crate has when it has fallen.
      expect(largestGain(world, 6), `${friction} N m`).toBeLessThan(1);
    }
  });
});
