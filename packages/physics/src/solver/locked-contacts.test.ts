// Contacts of bodies with locked axes: along those they bear as what does not move at all, however light they are.
import { box, energy, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it('a shelf of 0.1 kg that is locked bears a stack of ten crates of a ton each', () => {
    const world = rigidWorld({ precision });
    const locks = { x: true, y: true, angle: true };
    spawn(world, { position: { y: -0.1 }, collider: { shape: box(2, 0.2), density: 0.25 }, motionLocks: locks });
    const crate = { shape: box(1, 1), density: 1000, friction: 0.6 };
    const crates = Array.from({ length: 10 }, (_, i) => spawn(world, { position: { y: 0.5 + i }, collider: crate }));
    run(world, 2);
    crates.forEach((id, i) => {
      expect(Math.abs((world.components.Position.y[id] as number) - 0.5 - i)).toBeLessThan((i + 1) * SLOP);
      expect(Math.abs(world.components.Velocity.y[id] as number)).toBeLessThan(1e-3);
    });
  });

  it('heavy discs that fall through light pegs, which only turn, gain no energy', () => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -1 }, collider: { shape: box(100, 2), friction: 0.6 } });
    // A hundredth of the mass of a disc each.
    for (let row = 0; row < 5; row++) {
      for (let i = 0; i < 8; i++) {
        const position = { x: i + (row % 2) / 2 - 3.75, y: 2 + row };
        const collider = { shape: box(0.55, 0.55), density: 3, friction: 0.6 };
        spawn(world, { position, rotation: row + i, collider, motionLocks: { x: true, y: true } });
      }
    }
    for (let i = 0; i < 60; i++) {
      const position = { x: (i % 6) * 0.5 - 1.3, y: 8 + Math.floor(i / 6) * 0.5 };
      spawn(world, { position, collider: { radius: 0.2, density: 800, friction: 0.6, restitution: 0.3 } });
    }
    const start = energy(world).total;
    let before = start;
    for (let i = 0; i < 600; i++) {
      step(world, DT);
      const { total } = energy(world);
      // Discs sink into pegs that are so light, and are pushed out again: by 10 cm at most, of the ten metres that they fall.
      expect(total - before).toBeLessThan(0.01 * start);
      before = total;
    }
  });
});
