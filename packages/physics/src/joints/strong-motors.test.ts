// Motors against the limits of their own joints, however strong they are.
import {
  box,
  createJoint,
  destroyWorld,
  distance,
  jointPosition,
  prismatic,
  revolute,
  spawn,
  step,
} from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld, run, SLOP } from '../../../../test/support/rigid-world.ts';

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  /** A body of 3 kg at (4, 0), and what its joint measures four seconds later. */
  function positionAfter(join: (b: number) => Parameters<typeof createJoint>[1]): number {
    const world = rigidWorld({ precision, forces: [] });
    const b = spawn(world, { position: { x: 4 }, mass: 3, inertia: 1, collider: { radius: 0.3 } });
    const joint = createJoint(world, join(b));
    run(world, 4);
    const position = jointPosition(world, joint);
    destroyWorld(world);
    return position;
  }

  it.each([100, 1e4, 1e6, 1e9])('one of %d N or N m stops at the limit', (max) => {
    const lower = positionAfter((b) => distance({ b, anchorA: {}, limits: { lower: 1 }, motor: { speed: -1, max } }));
    expect(Math.abs(lower - 1)).toBeLessThan(SLOP);
    const upper = positionAfter((b) => distance({ b, anchorA: {}, limits: { upper: 5 }, motor: { speed: 1, max } }));
    expect(Math.abs(upper - 5)).toBeLessThan(SLOP);
    const slider = positionAfter((b) =>
      prismatic({ b, anchor: { x: 4 }, axis: { x: 1 }, limits: { lower: -3 }, motor: { speed: -1, max } }),
    );
    expect(Math.abs(slider + 3)).toBeLessThan(SLOP);
    const hinge = positionAfter((b) =>
      revolute({ b, anchor: { x: 4 }, limits: { upper: 0.5 }, motor: { speed: 1, max } }),
    );
    expect(Math.abs(hinge - 0.5)).toBeLessThan(SLOP);
  });

  it('a distance joint with nothing but a motor is a winch', () => {
    // 0.5 m/s for four seconds, but for the first sub-step, in which 100 N bring 3 kg to that speed.
    const length = positionAfter((b) => distance({ b, anchorA: {}, motor: { speed: -0.5, max: 1000 } }));
    expect(Math.abs(length - 2)).toBeLessThan(0.5 / 240);
  });

  it.each([1e3, 1e5, 1e7])('one of %d N m lifts a bar off its limit no faster than its speed', (max) => {
    const world = rigidWorld({ precision });
    const bar = spawn(world, { position: { x: 1 }, collider: { shape: box(2, 0.2), density: 100 } });
    const joint = createJoint(world, revolute({ b: bar, anchor: {}, limits: { lower: -0.1, upper: 1 } }));
    run(world, 2);
    const rest = jointPosition(world, joint);
    const speed = 0.01;
    const { Joint } = world.components;
    Joint.motorSpeed[joint] = speed;
    Joint.maxMotor[joint] = max;
    let before = rest;
    for (let k = 0; k < 120; k++) {
      step(world, DT);
      const position = jointPosition(world, joint);
      // Beside what angles of 0.1 rad are rounded by.
      expect(position - before).toBeLessThan(1.01 * speed * DT);
      before = position;
    }
    // By itself the motor takes over what the limit bears by as much as gives the bar its speed: 0.5 N m s of 1.6 in a pass.
    expect(before - rest).toBeGreaterThan(speed * (2 - 2 * DT));
  });

  it('one beside a spring comes to its speed and no further', () => {
    const world = rigidWorld({ precision, forces: [] });
    const b = spawn(world, { position: { x: 1 }, mass: 10, inertia: 1, collider: { radius: 0.2 } });
    // 50 N m bring 11 kg m² to 1 rad/s in a quarter of a second, against a spring that takes up to 0.3 of them.
    const motor = { speed: 1, max: 50 };
    createJoint(world, revolute({ b, anchor: {}, spring: { hertz: 1, dampingRatio: 0.1 }, motor }));
    const { z: spin } = world.components.AngularVelocity;
    let most = 0;
    for (let k = 0; k < 40; k++) {
      step(world, DT);
      most = Math.max(most, spin[b]);
    }
    expect(most).toBeGreaterThan(0.999);
    expect(most).toBeLessThan(1.001);
  });
});
