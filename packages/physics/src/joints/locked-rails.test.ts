// Rods and ropes that pull a body across the axis along which locks let it move.
import { createJoint, distance, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

describe.each(['f32', 'f64'] as const)('in %s a bead on a level rail', (precision) => {
  it.each([
    ['rope', 0.01],
    ['rope', 0.1],
    ['rod', 0.01],
    ['rod', 0.1],
  ])('rests where a %s that ends %f m aside, and 1 cm too high to be reached, pulls it', (kind, aside) => {
    const world = rigidWorld({ precision, forces: [] });
    const bead = spawn(world, { position: {}, motionLocks: { y: true }, collider: { radius: 0.2, density: 10 } });
    const length = Math.hypot(aside, 3) - 0.01;
    createJoint(
      world,
      distance({
        b: bead,
        anchorA: { x: aside, y: 3 },
        ...(kind === 'rope' ? { limits: { upper: length } } : { length }),
      }),
    );
    const { Position, Velocity } = world.components;
    for (let i = 0; i < 300; i++) {
      step(world, DT);
      // It is drawn to the place below the end, and turns back 2 mm beyond; what corrects a length leaves no speed.
      expect(Math.abs(Velocity.x[bead])).toBeLessThan(0.1);
      expect(Position.x[bead]).toBeGreaterThan(-1e-6);
      expect(Position.x[bead]).toBeLessThan(aside + 3e-3);
    }
  });

  it('moves along as a rod from the side pulls it, as if there were no rail', () => {
    const world = rigidWorld({ precision, forces: [] });
    const cart = spawn(world, { position: {}, velocity: { x: 1 }, collider: { radius: 0.2, mask: 0 } });
    const bead = spawn(world, { position: { x: -2, y: 1 }, motionLocks: { y: true }, mass: 5, inertia: 1 });
    createJoint(world, distance({ a: cart, b: bead, anchorA: { x: 0, y: 0 }, anchorB: { x: -2, y: 1 } }));
    const { Position } = world.components;
    for (let i = 0; i < 120; i++) step(world, DT);
    expect(Position.x[cart]).toBeCloseTo(2, 4);
    expect(Position.x[bead]).toBeCloseTo(0, 3);
    expect(Position.y[bead]).toBe(1);
  });
});
