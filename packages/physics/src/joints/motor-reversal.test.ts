// A motor that cannot reach its speed is a torque, also when its speed changes sign: what learns to walk gives torques so.
import { box, capsule, createJoint, destroyWorld, revolute, softStep, spawn, step } from '@principia/physics';
import { describe, expect, it } from 'vitest';
import { DT, rigidWorld } from '../../../../test/support/rigid-world.ts';

const TORQUE = 1;

describe.each(['f32', 'f64'] as const)('in %s', (precision) => {
  it.each([4, 100, 1000])(
    'a motor whose speed of %d rad/s changes sign again and again turns a rod by its torque',
    (speed) => {
      const world = rigidWorld({ precision, capacity: 10, forces: [] });
      const rod = spawn(world, { position: { x: 0.5 }, mass: 1, collider: { shape: box(1, 0.05), mask: 0 } });
      const joint = createJoint(world, revolute({ b: rod, anchor: {}, motor: { speed, max: TORQUE } }));
      const { AngularVelocity, Inertia, Joint, Position } = world.components;
      // About the hinge, by Steiner's theorem. The hinge is a spring of 72 Hz: the rod turns as if its centre were 1e-3 farther out.
      const inertia = Inertia.value[rod] + 0.5 ** 2;
      for (let i = 0; i < 120; i++) {
        const sign = i % 3 === 0 ? -1 : 1;
        Joint.motorSpeed[joint] = sign * speed;
        const before = AngularVelocity.z[rod];
        step(world, DT);
        const change = (sign * TORQUE * DT) / inertia;
        expect(Math.abs(AngularVelocity.z[rod] - before - change)).toBeLessThan(2e-3 * Math.abs(change));
      }
      expect(Math.abs(Math.hypot(Position.x[rod], Position.y[rod]) - 0.5)).toBeLessThan(1e-3);
      destroyWorld(world);
    },
  );

  // Friction at each hinge reverses once in a turn of the crank. Of a coupler of 2 m and a rocker of 1.8 m on a crank of 0.5 m that turns
  // at 2 rad/s, the middle goes at 1.0222 m/s at most, by the closure of the four bars.
  it('a four-bar linkage with friction at three hinges goes as its crank turns', () => {
    const world = rigidWorld({ precision, capacity: 10, integrator: softStep({ sleepTime: 0 }) });
    const motor = { speed: 0, max: 0.5 };
    const crank = spawn(world, {
      position: {},
      velocity: {},
      rotation: 0,
      angularVelocity: 2,
      collider: { radius: 0.5, mask: 0 },
    });
    const pin = { x: 0.5, y: 0 };
    const far = { x: 0.5 + Math.sqrt(3), y: 1 };
    const ground = { x: far.x + 0.2, y: far.y - Math.sqrt(1.8 ** 2 - 0.2 ** 2) };
    const bar = (p: typeof pin, q: typeof pin, length: number) =>
      spawn(world, {
        position: { x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 },
        rotation: Math.atan2(q.y - p.y, q.x - p.x),
        collider: { shape: capsule(length, 0.05), density: 10, mask: 0 },
      });
    const coupler = bar(pin, far, 2);
    const rocker = bar(far, ground, 1.8);
    createJoint(world, revolute({ a: crank, b: coupler, anchor: pin, motor }));
    createJoint(world, revolute({ a: coupler, b: rocker, anchor: far, motor }));
    createJoint(world, revolute({ b: rocker, anchor: ground, motor }));
    const { Velocity } = world.components;
    let fastest = 0;
    for (let i = 0; i < 1200; i++) {
      step(world, DT);
      fastest = Math.max(fastest, Math.hypot(Velocity.x[coupler], Velocity.y[coupler]));
    }
    // First order in the sub-step of 1/240 s, in which the crank turns by 8e-3 rad.
    expect(Math.abs(fastest / 1.0222 - 1)).toBeLessThan(8e-3);
    destroyWorld(world);
  });
});
