// Contacts of bodies with locked axes: along those they bear as what does not move at all, however light they are.
import { box, energy, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, G, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

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

  it.each([
    ['nothing', {}],
    ['the angle', { angle: true }],
    ['x', { x: true }],
    ['x and the angle', { x: true, angle: true }],
  ])('a disc with e = 1 of which %s is locked bounces for a minute as one that is free', (_, motionLocks) => {
    const bounce = (locks?: object) => {
      const world = rigidWorld({ precision });
      spawn(world, { position: { y: -1 }, collider: { shape: box(20, 2), restitution: 1, friction: 0 } });
      const collider = { radius: 0.5, density: 1, restitution: 1, friction: 0 };
      const disc = spawn(world, { position: { y: 2.5 }, collider, ...(locks ? { motionLocks: locks } : {}) });
      run(world, 60);
      return [world.components.Position.y[disc], world.components.Velocity.y[disc]];
    };
    expect(bounce(motionLocks)).toEqual(bounce());
  });

  it.each([
    ['nothing', {}],
    ['the angle', { angle: true }],
    ['x', { x: true }],
    ['x and the angle', { x: true, angle: true }],
  ])('a box with e = 1 of which %s is locked bounces for a minute as high as it fell from', (_, motionLocks) => {
    const world = rigidWorld({ precision });
    spawn(world, { position: { y: -1 }, collider: { shape: box(20, 2), restitution: 1, friction: 0 } });
    const collider = { shape: box(0.8, 0.8), density: 1, restitution: 1, friction: 0 };
    spawn(world, { position: { y: 2.4 }, collider, motionLocks });
    const start = energy(world).total;
    run(world, 60);
    // It keeps e² of its height within 2 g Δt / v, where v is the speed at which it lands; errors of one sense would add up.
    expect(Math.abs(energy(world).total / start - 1)).toBeLessThan((2 * G * DT) / Math.sqrt(2 * G * 2));
  });

  it.each([0, 1])('what falls on a slope stays where x is locked, with e = %d', (restitution) => {
    const world = rigidWorld({ precision });
    spawn(world, { position: {}, rotation: Math.PI / 4, collider: { shape: box(60, 1), restitution } });
    const motionLocks = { x: true, angle: true };
    const bodies = [{ radius: 0.5 }, { shape: box(0.8, 0.8) }].map((collider, i) => {
      // Along the slope, at the same height above it.
      const at = { x: 6 * i, y: 3 + 6 * i };
      return spawn(world, { position: at, motionLocks, collider: { ...collider, density: 10, restitution } });
    });
    run(world, 20);
    bodies.forEach((body, i) => {
      expect(world.components.Position.x[body]).toBe(6 * i);
      // Of a disc that rests the centre is √2 R above the slope, whose middle line is at y = x, and its surface √½ m above that.
      expect(world.components.Position.y[body]).toBeGreaterThan(6 * i + Math.SQRT1_2 + Math.SQRT1_2 - 0.01);
    });
  });
});
