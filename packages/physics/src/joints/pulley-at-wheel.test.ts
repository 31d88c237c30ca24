// What a rope draws up to its wheel comes to rest there, and the rope keeps its length.
import { box, createJoint, destroyWorld, jointForce, pulley, spawn, step } from '@principia/physics';
import { expect, it } from 'vitest';
import { DT, G, rigidWorld } from '../../../../test/support/rigid-world.ts';

const wheels = { pulleyA: { x: -2, y: 10 }, pulleyB: { x: 2, y: 10 } };

it.each([
  [200, 1, 2],
  [2000, 1, 2],
  [2000, 1, 2.5],
  [2000, 2, 2],
  [20_000, 1, 2],
])('%d kg draw up 100 kg by a ratio of %d, from x = %d', (mass, ratio, x) => {
  for (const precision of ['f32', 'f64'] as const) {
    const world = rigidWorld({ precision });
    const a = spawn(world, { position: { x: -2, y: 5 }, mass, collider: { shape: box(1, 1) } });
    const b = spawn(world, { position: { x, y: 8 }, mass: 100, collider: { shape: box(1, 1) } });
    const rope = createJoint(world, pulley({ a, b, ratio, ...wheels }));
    const { Position } = world.components;
    const lengthOfRope = () => 10 - Position.y[a] + ratio * Math.hypot(Position.x[b] - 2, Position.y[b] - 10);
    const start = lengthOfRope();
    for (let i = 0; i < 10 / DT; i++) step(world, DT);
    for (let i = 0; i < 5 / DT; i++) {
      step(world, DT);
      // To the millimetre: g/(2π 72 Hz)² is 0.05 mm.
      expect(Math.abs(lengthOfRope() - start)).toBeLessThan(1e-3);
      // The end b is at its wheel, and hangs by its own weight.
      expect(Math.hypot(Position.x[b] - 2, Position.y[b] - 10)).toBeLessThan(1e-2);
    }
    expect(jointForce(world, rope)).toBeGreaterThan(0.9 * 100 * G);
    destroyWorld(world);
  }
});
